#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "breccia/campaign/run.hpp"
#include "breccia/campaign/sweep.hpp"

namespace breccia::cli {

/// What every subcommand that reads a deck takes.
struct DeckArguments {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::vector<std::string> swept;  ///< `key.path=[value, ...]`
  int seeds = 0;                   ///< of all random packings; 0: those of the deck

  [[nodiscard]] Sweep read() const;
};

/// Adds DECK, --set, --sweep and --seeds to a subcommand. The arguments must live as long as the application.
void add_deck_arguments(CLI::App& command, DeckArguments& arguments);

/// What every subcommand that computes takes besides.
struct RunArguments {
  DeckArguments deck;
  std::filesystem::path directory;  ///< empty: results/<deck name>
  int threads = 0;                  ///< 0: all
  bool quiet = false;
  bool resume = false;
  bool overwrite = false;
  bool ignore_memory = false;
  int processes_per_task = 0;                  ///< of a sweep; 0: all
  std::string petsc_options;                   ///< as on a command line of PETSc
  std::string time_limit;                      ///< with its unit; empty: none
  std::string checkpoint_interval = "10 min";  ///< with its unit

  /// Where the results go.
  [[nodiscard]] std::filesystem::path results() const;
  /// How the study is to be run; a limit of time counts from now. Throws InputError, naming the option.
  [[nodiscard]] RunOptions options() const;
};

/// Adds DECK, --set, --sweep, --seeds, --out, --threads and --quiet, and what tells when states are left and taken up:
/// --resume,
/// --time-limit and --checkpoint-interval.
void add_run_arguments(CLI::App& command, RunArguments& arguments);

/// Says on standard error when gnuplot cannot draw, why, and that its plots will be left out; with an addition that
/// begins by its own punctuation.
void warn_of_missing_plots(const std::string& addition);

/// The subcommands: each adds itself to the application, and does its work in a callback.
void add_bench(CLI::App& application);
void add_check(CLI::App& application);
void add_examples(CLI::App& application);
void add_fit(CLI::App& application);
void add_help(CLI::App& application);
void add_new(CLI::App& application);
void add_pack(CLI::App& application);
void add_report(CLI::App& application);
void add_respond(CLI::App& application);
void add_run(CLI::App& application);
void add_stages(CLI::App& application);

}  // namespace breccia::cli

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "breccia/campaign/run.hpp"

#include "campaign/sweep.hpp"
#include "cli/detail.hpp"
#include "io/range.hpp"

namespace breccia::cli {

/// The arguments of every subcommand that reads a deck.
struct DeckArguments {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::vector<std::string> swept;  ///< swept keys, `key.path=[value, ...]`
  int seeds = 0;                   ///< number of seeds for all random packings; 0: the seeds of the deck

  [[nodiscard]] Sweep read() const;
};

/// Adds DECK, --set, --sweep and --seeds to a subcommand. The arguments must live as long as the application.
void add_deck_arguments(CLI::App& command, DeckArguments& arguments);

/// The further arguments of every subcommand that computes.
struct RunArguments {
  DeckArguments deck;
  std::filesystem::path directory;  ///< directory of the results; empty: results/<deck name>
  int threads = 0;                  ///< number of threads; 0: all cores
  bool quiet = false;
  bool verbose = false;
  bool resume = false;
  bool overwrite = false;
  bool ignore_memory = false;
  int processes_per_task = 0;                  ///< processes for each task of a sweep; 0: all
  std::string petsc_options;                   ///< options of PETSc, in the form of its command line
  std::string time_limit;                      ///< time limit with its unit; empty: none
  std::string checkpoint_interval = "10 min";  ///< interval with its unit

  [[nodiscard]] Detail detail() const { return verbose ? Detail::full : Detail::brief; }
  /// The directory for the results.
  [[nodiscard]] std::filesystem::path results() const;
  /// The options for the run; the time limit counts from now. Throws InputError with the name of the bad option.
  [[nodiscard]] RunOptions options() const;
};

/// Adds DECK, --set, --sweep, --seeds, --out, --threads, --quiet and the options for checkpoints: --resume,
/// --time-limit and --checkpoint-interval.
void add_run_arguments(CLI::App& command, RunArguments& arguments);

/// The value of an option as a quantity in its SI unit. Throws InputError with the name of the option if it is no such
/// quantity or out of range.
double option_quantity(const std::string& option, const std::string& text, Dimension dimension,
                       const Range& range = {});

/// A positive share of an option, such as "2 %"; nothing for an empty text. Throws InputError with the name of the
/// option.
std::optional<double> option_share(const std::string& option, const std::string& text);

/// The subcommands: each function adds its subcommand to the application, with a callback that does the work.
void add_assess(CLI::App& application);
void add_bench(CLI::App& application);
void add_calibrate(CLI::App& application);
void add_check(CLI::App& application);
void add_compare(CLI::App& application);
void add_completion(CLI::App& application);
void add_examples(CLI::App& application);
void add_export(CLI::App& application);
void add_find(CLI::App& application);
void add_fit(CLI::App& application);
void add_help(CLI::App& application);
void add_mesh(CLI::App& application);
void add_new(CLI::App& application);
void add_pack(CLI::App& application);
void add_report(CLI::App& application);
void add_respond(CLI::App& application);
void add_run(CLI::App& application);
void add_stages(CLI::App& application);
void add_studio(CLI::App& application);

}  // namespace breccia::cli

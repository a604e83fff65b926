#include "cli/command.hpp"

#include <chrono>
#include <string>

#include <fmt/format.h>

#include "breccia/deck/read_sweep.hpp"
#include "breccia/error.hpp"

#include "cli/help.hpp"
#include "cli/interruption.hpp"
#include "io/percentage.hpp"
#include "io/units.hpp"
#include "parallel/session.hpp"

namespace breccia::cli {

Sweep DeckArguments::read() const {
  auto keys = swept;
  if (seeds > 0) keys.push_back(fmt::format("stages.*.packing.seed={{ from = 1, to = {} }}", seeds));
  return read_sweep(deck, overrides, keys);
}

void add_deck_arguments(CLI::App& command, DeckArguments& arguments) {
  command.footer(where_to_begin());
  command.add_option("DECK", arguments.deck, "the study, a TOML file")->required()->type_name("");
  command
      .add_option("--set", arguments.overrides,
                  "replace a value of the deck, as in stages.HB-1.cells=100; may be repeated")
      ->type_name("KEY.PATH=VALUE")
      ->allow_extra_args(false);
  command
      .add_option(
          "--sweep", arguments.swept,
          "run the deck for each of several values, as in 'stages.*.packing.seed=[1, 2, 3]'; may be repeated, for "
          "all combinations")
      ->type_name("KEY.PATH=[VALUE, ...]")
      ->allow_extra_args(false);
  constexpr int most_seeds = 1000;
  command
      .add_option(
          "--seeds", arguments.seeds,
          "run the deck with the seeds 1 to N for its random packings: mean and spread of the moduli; short for "
          "--sweep 'stages.*.packing.seed={ from = 1, to = N }'")
      ->type_name("N")
      ->check(CLI::Range(2, most_seeds).description(""));
}

void add_run_arguments(CLI::App& command, RunArguments& arguments) {
  add_deck_arguments(command, arguments.deck);
  command.add_option("--out", arguments.directory, "directory for the results (default: results/<name of the deck>)")
      ->type_name("DIR");
  command
      .add_option("--threads", arguments.threads,
                  "number of threads of each process (default: as many as help, at most one for each core, shared by "
                  "processes)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
  command.add_flag("--quiet", arguments.quiet, "print nothing but warnings and errors");
  command.add_flag("--resume", arguments.resume,
                   "continue a run that was interrupted or killed; complete results are kept");
  command
      .add_option("--time-limit", arguments.time_limit,
                  "write a checkpoint after this time and end with exit code 130, as in \"11 h\"")
      ->type_name("TIME");
  command
      .add_option("--checkpoint-interval", arguments.checkpoint_interval,
                  "time from one checkpoint to the next (default: \"10 min\")")
      ->type_name("TIME");
}

std::filesystem::path RunArguments::results() const {
  return directory.empty() ? std::filesystem::path("results") / deck.deck.stem() : directory;
}

RunOptions RunArguments::options() const {
  RunOptions options = {
      .solve = {.threads = threads, .ignore_memory = ignore_memory}, .resume = resume, .overwrite = overwrite};
  const auto seconds_of = [](const char* option, const std::string& text) {
    return option_quantity(option, text, Dimension::time, Range::positive());
  };
  options.checkpoints.interval = seconds_of("--checkpoint-interval", checkpoint_interval);
  options.checkpoints.stop = interruption_requested;
  if (!time_limit.empty()) {
    const std::chrono::duration<double> limit(seconds_of("--time-limit", time_limit));
    options.checkpoints.stop = [end = std::chrono::steady_clock::now() + limit] {
      return interruption_requested() || std::chrono::steady_clock::now() >= end;
    };
  }
  return options;
}

double option_quantity(const std::string& option, const std::string& text, Dimension dimension, const Range& range) {
  const auto value = [&] {
    try {
      return parse_quantity(text, dimension);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", option, error.what()));
    }
  }();
  if (accepts(range, value)) return value;
  throw InputError(fmt::format("{}: expected {}, got \"{}\"", option, described(range, dimension), text));
}

std::optional<double> option_share(const std::string& option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto share = parse_percentage(text);
  if (share && *share > 0.0 && *share < 1.0) return share;
  throw InputError(
      fmt::format(R"({}: expected a percentage between 0 and 100, such as "2 %", got "{}")", option, text));
}

}  // namespace breccia::cli

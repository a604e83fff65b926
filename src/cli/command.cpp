#include "command.hpp"

namespace breccia::cli {

void add_deck_arguments(CLI::App& command, DeckArguments& arguments) {
  command.add_option("DECK", arguments.deck, "the study, a TOML file")->required()->type_name("");
  command
      .add_option("--set", arguments.overrides,
                  "replace a value of the deck, as in stages.HB-1.cells=100; may be repeated")
      ->type_name("KEY.PATH=VALUE")
      ->allow_extra_args(false);
  command
      .add_option("--sweep", arguments.swept,
                  "run the deck for each of some values, as in 'stages.*.packing.seed=[1, 2, 3]'; may be repeated, for "
                  "all combinations")
      ->type_name("KEY.PATH=[VALUE, ...]")
      ->allow_extra_args(false);
}

void add_run_arguments(CLI::App& command, RunArguments& arguments) {
  add_deck_arguments(command, arguments.deck);
  command.add_option("--out", arguments.directory, "where the results go (default: results/<name of the deck>)")
      ->type_name("DIR");
  command.add_option("--threads", arguments.threads, "threads to use (default: one for each core)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--quiet", arguments.quiet, "print nothing but errors");
}

std::filesystem::path RunArguments::results() const {
  return directory.empty() ? std::filesystem::path("results") / deck.deck.stem() : directory;
}

}  // namespace breccia::cli

#include "command.hpp"

namespace breccia::cli {

void add_deck_arguments(CLI::App& command, DeckArguments& arguments) {
  command.add_option("DECK", arguments.deck, "the study, a TOML file")->required()->type_name("");
  command
      .add_option("--set", arguments.overrides,
                  "replace a value of the deck, as in stages.HB-1.cells=100; may be repeated")
      ->type_name("KEY.PATH=VALUE")
      ->allow_extra_args(false);
}

}  // namespace breccia::cli

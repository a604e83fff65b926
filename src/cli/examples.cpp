#include <fmt/format.h>

#include "cli/command.hpp"
#include "cli/installation.hpp"
#include "studio/example_decks.hpp"

namespace breccia::cli {
namespace {

constexpr auto pages = R"(  README.md               an overview of all pages
  tutorial.md             the first half hour
  tutorial-image.md       from a micrograph to G(t)
  glossary.md             the words and symbols
  boundary-conditions.md  which boundary condition, and how large a box
  decks.md                every key of a deck
  results.md              every file that a run writes
  fitting.md              from measured data to a Prony series
)";

void print_examples() {
  const auto examples = installed_examples();
  const auto documentation = installed_documentation();
  fmt::print("Decks in {} (run one by its path, or copy it):\n", examples.string());
  for (const auto& deck : studio::example_decks(examples)) fmt::print("  {:<30}  {}\n", deck.name, deck.title);
  fmt::print(
      "A copy of a deck that names files in ../data/ needs a copy of {}\n"
      "beside the folder of the deck; without it the deck is refused.\n",
      (examples.parent_path() / "data").string());
  fmt::print("\nDocumentation in {}:\n", (documentation / "docs").string());
  fmt::print("{}", pages);
}

}  // namespace

void add_examples(CLI::App& application) {
  auto* command = application.add_subcommand("examples", "list the decks and the documentation that came with breccia");
  command->callback(print_examples);
}

}  // namespace breccia::cli

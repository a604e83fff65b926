#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "breccia/study/deck.hpp"

#include "command.hpp"
#include "summary.hpp"

namespace breccia::cli {

void add_check(CLI::App& application) {
  auto* command = application.add_subcommand("check", "read a deck, report every mistake in it, show what it means");
  auto arguments = std::make_shared<DeckArguments>();
  add_deck_arguments(*command, *arguments);
  command->callback([arguments] {
    const auto study = read_study(arguments->deck, arguments->overrides);
    fmt::print("{}", summary(study));
  });
}

}  // namespace breccia::cli

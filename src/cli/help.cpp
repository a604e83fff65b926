#include "cli/help.hpp"

#include <memory>
#include <string>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "cli/command.hpp"
#include "cli/misuse.hpp"

namespace breccia::cli {
namespace {

/// The help of a command as `--help` prints it.
std::string help_of(const CLI::App& command, const std::string& name) {
  return command.get_formatter()->make_help(&command, name, CLI::AppFormatMode::Normal);
}

}  // namespace

std::string where_to_begin() {
  return "A deck to begin with: breccia new NAME.toml. The keys of a deck: docs/decks.md (breccia examples tells "
         "where).";
}

void add_help(CLI::App& application) {
  auto* command = application.add_subcommand("help", "show the help of a command, as breccia COMMAND --help does");
  auto name = std::make_shared<std::string>();
  command->add_option("COMMAND", *name, "the command (default: an overview of all commands)")->type_name("");
  command->callback([&application, name] {
    if (name->empty()) {
      fmt::print("{}", help_of(application, application.get_name()));
      return;
    }
    const auto of_that_name =
        application.get_subcommands([&](const CLI::App* one) { return one->get_name() == *name; });
    if (of_that_name.empty()) throw InputError(unknown_command(application, *name));
    fmt::print("{}", help_of(*of_that_name.front(), fmt::format("{} {}", application.get_name(), *name)));
  });
}

}  // namespace breccia::cli

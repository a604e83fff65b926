#include "cli/misuse.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/nearest_name.hpp"

namespace breccia::cli {
namespace {

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

/// The name of an option without its value: `--threads` for `--threads=2`.
std::string name_of_option(const std::string& word) {
  return word.substr(0, word.find('='));
}

/// The long names of the options of a command.
std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const auto* option : command.get_options({})) {
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

bool has_option(const CLI::App& command, const std::string& name) {
  return std::ranges::count(options_of(command), name) > 0;
}

/// The message about an unknown option: `unknown option "--thread", did you mean "--threads"?` For an abbreviation,
/// such as `-t` or `--check`, it suggests all options that begin in this way.
std::string unknown_option(const CLI::App& command, const std::string& name) {
  const auto known = options_of(command);
  const auto beginning = name.starts_with("--") ? name : "-" + name;
  std::vector<std::string> longer;
  std::ranges::copy_if(known, std::back_inserter(longer),
                       [&](const std::string& option) { return option.starts_with(beginning); });
  const auto hint =
      longer.empty() ? suggestion(name, known) : fmt::format(", did you mean \"{}\"?", fmt::join(longer, "\" or \""));
  return fmt::format("unknown option \"{}\"{}", name, hint);
}

/// The names of the positional arguments of a command, such as DECK.
std::vector<std::string> positionals_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const auto* option : command.get_options({})) {
    if (option->get_positional()) names.push_back(option->get_name());
  }
  return names;
}

/// The mistakes in options. CLI11 takes an option before the command for one of the program itself.
std::vector<std::string> mistaken_options(const CLI::App& application, const CLI::App& command) {
  std::vector<std::string> lines;
  for (const auto& word : application.remaining()) {
    if (!is_option(word)) continue;
    const auto name = name_of_option(word);
    const bool is_misplaced = &command != &application && has_option(command, name);
    lines.push_back(is_misplaced ? fmt::format("option \"{}\" stands before the command: expected breccia {} {}", name,
                                               command.get_name(), name)
                                 : unknown_option(application, name));
  }
  if (&command == &application) return lines;
  for (const auto& word : command.remaining()) {
    if (is_option(word)) lines.push_back(unknown_option(command, name_of_option(word)));
  }
  return lines;
}

/// Messages about the superfluous arguments of a command.
std::vector<std::string> unexpected_arguments(const CLI::App& application, const CLI::App& command) {
  const auto positionals = positionals_of(command);
  const auto expected = positionals.empty() ? "options alone" : fmt::format("one {}", fmt::join(positionals, ", "));
  std::vector<std::string> lines;
  for (const auto& word : application.remaining(true)) {
    lines.push_back(fmt::format("unexpected argument \"{}\": breccia {} takes {}", word, command.get_name(), expected));
  }
  return lines;
}

}  // namespace

std::string unknown_command(const CLI::App& application, const std::string& name) {
  std::vector<std::string> commands;
  for (const auto* command : application.get_subcommands({})) commands.push_back(command->get_name());
  return fmt::format("unknown command \"{}\"{}", name, suggestion(name, commands));
}

std::string describe_misuse(const CLI::App& application, const CLI::ParseError& error) {
  const auto chosen = application.get_subcommands();
  const CLI::App& command = chosen.empty() ? application : *chosen.front();
  const auto words = application.remaining();
  if (chosen.empty() && !words.empty() && !is_option(words.front())) return unknown_command(application, words.front());

  auto lines = mistaken_options(application, command);
  const bool is_about_extras = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  // After an unknown option a superfluous argument is probably its value, and is not reported.
  if (is_about_extras && lines.empty()) lines = unexpected_arguments(application, command);
  const bool lacks_command_alone = chosen.empty() && !lines.empty();
  if (!is_about_extras && !lacks_command_alone) lines.emplace_back(error.what());
  const auto name = chosen.empty() ? "breccia" : "breccia " + command.get_name();
  return fmt::format("{}\n\"{} --help\" shows how it is used", fmt::join(lines, "\n"), name);
}

}  // namespace breccia::cli

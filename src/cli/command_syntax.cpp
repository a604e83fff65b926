#include "cli/command_syntax.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace breccia::cli {
namespace {

std::vector<std::string> names_of_commands(const CLI::App& application) {
  std::vector<std::string> names;
  for (const auto* command : application.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// The parts of a text between the marks.
std::vector<std::string> split(std::string_view text, char mark) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (auto end = text.find(mark); end != std::string_view::npos; end = text.find(mark, begin)) {
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.emplace_back(text.substr(begin));
  return parts;
}

/// The kind of a value by the name that the help gives it: words with bars between them (`shear|young|bulk`), DIR, the
/// suffix of a file (NAME.toml), a deck, a table or any file.
ValueSyntax value_of_name(const std::string& name) {
  constexpr auto deck_suffix = ".toml";
  if (name.find('|') != std::string::npos) return {name, ValueKind::word, split(name, '|')};
  if (name == "DIR") return {name, ValueKind::directory};
  if (name == "FILE") return {name, ValueKind::file};
  if (name == "DECK" || name.ends_with(deck_suffix)) return {name, ValueKind::file, {}, deck_suffix};
  if (name == "SIZES") return {name, ValueKind::file, {}, ".csv"};
  return {name};
}

/// The values of an option: BEGIN END are two of them; N ... are one or more, of which one is described.
std::vector<ValueSyntax> values_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return {};
  auto name = option.get_type_name();
  constexpr std::string_view more = " ...";
  if (name.ends_with(more)) name.resize(name.size() - more.size());
  if (option.get_items_expected_max() != 2) return {value_of_name(name)};
  std::vector<ValueSyntax> values;
  for (const auto& one : split(name, ' ')) values.push_back(value_of_name(one));
  return values;
}

/// The description as far as the first example, default or remark.
std::string first_clause_of(const std::string& description) {
  const auto end = std::min({description.find("; "), description.find(" ("), description.find(", as in "),
                             description.find(", such as "), description.find(": ")});
  return description.substr(0, end);
}

OptionSyntax syntax_of(const CLI::Option& option) {
  OptionSyntax syntax = {{}, first_clause_of(option.get_description()), values_of(option)};
  for (const auto& name : option.get_snames()) syntax.names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) syntax.names.push_back("--" + name);
  // The option is repeatable if it takes any number of values, or the values of all its uses.
  syntax.is_repeatable = option.get_expected_max() >= CLI::detail::expected_max_vector_size ||
                         option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  return syntax;
}

ValueSyntax argument_of(const CLI::Option& argument, const CLI::App& application) {
  if (argument.get_name() == "COMMAND") return {"COMMAND", ValueKind::word, names_of_commands(application)};
  const auto type = argument.get_type_name();
  return value_of_name(type.empty() ? argument.get_name() : type);
}

CommandSyntax syntax_of(const CLI::App& command, const CLI::App& application) {
  CommandSyntax syntax = {command.get_name(), first_clause_of(command.get_description()), {}, {}};
  for (const auto* option : command.get_options({})) {
    if (option->get_positional()) {
      syntax.arguments.push_back(argument_of(*option, application));
    } else {
      syntax.options.push_back(syntax_of(*option));
    }
  }
  return syntax;
}

}  // namespace

CommandSyntax syntax_of_program(const CLI::App& application) {
  auto syntax = syntax_of(application, application);
  syntax.arguments = {{"COMMAND", ValueKind::word, names_of_commands(application)}};
  return syntax;
}

std::vector<CommandSyntax> syntax_of_commands(const CLI::App& application) {
  std::vector<CommandSyntax> commands;
  for (const auto* command : application.get_subcommands({})) commands.push_back(syntax_of(*command, application));
  return commands;
}

}  // namespace breccia::cli

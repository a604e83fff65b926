#include "cli/zsh_completion.hpp"

#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/command_syntax.hpp"

namespace breccia::cli {
namespace {

/// The text with a backslash before each of the marks.
std::string escaped(std::string_view text, std::string_view marks) {
  std::string result;
  for (const char c : text) {
    if (marks.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

/// A text as one word of the shell, whatever its characters are.
std::string shell_word(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      result += c;
    }
  }
  return result + "'";
}

/// The completion of a value, as an action of zsh's function `_arguments`.
std::string action_of(const ValueSyntax& value) {
  switch (value.kind) {
    case ValueKind::text:
      return " ";
    case ValueKind::word:
      return fmt::format("({})", fmt::join(value.words, " "));
    case ValueKind::directory:
      return "_files -/";
    case ValueKind::file:
      return value.suffix.empty() ? "_files" : fmt::format("_files -g \"*{}\"", value.suffix);
  }
  return {};
}

/// `:message:action`, as `_arguments` takes it. The words of a value are its completions, and its message is short.
std::string message_and_action(const ValueSyntax& value) {
  return fmt::format(":{}:{}", value.kind == ValueKind::word ? "word" : escaped(value.name, ":\\"), action_of(value));
}

/// The specification of an option: '(-h --help)'{-h,--help}'[print this help]', '*--set[...]:KEY.PATH=VALUE: '.
std::string specification_of(const OptionSyntax& option) {
  std::string rest = fmt::format("[{}]", escaped(option.summary, "[]:\\"));
  for (const auto& value : option.values) rest += message_and_action(value);
  if (option.names.size() > 1) {
    return fmt::format("'({})'{{{}}}{}", fmt::join(option.names, " "), fmt::join(option.names, ","), shell_word(rest));
  }
  return shell_word(fmt::format("{}{}{}", option.is_repeatable ? "*" : "", option.names.front(), rest));
}

std::string function_of(const CommandSyntax& command) {
  std::string text = fmt::format("_breccia_{}() {{\n  _arguments -s -S", command.name);
  for (const auto& option : command.options) text += fmt::format(" \\\n    {}", specification_of(option));
  for (const auto& argument : command.arguments) {
    text += fmt::format(" \\\n    {}", shell_word(fmt::format("1{}", message_and_action(argument))));
  }
  return text + "\n}\n\n";
}

}  // namespace

std::string zsh_completion(const CLI::App& application) {
  std::string text = "#compdef breccia\n# Completion of breccia for zsh: what `breccia completion zsh` prints.\n\n";
  std::string commands;
  for (const auto& command : syntax_of_commands(application)) {
    text += function_of(command);
    commands +=
        fmt::format("        {}\n", shell_word(fmt::format("{}:{}", command.name, escaped(command.summary, ":\\"))));
  }
  std::string options;
  for (const auto& option : syntax_of_program(application).options) {
    options += fmt::format("    {} \\\n", specification_of(option));
  }
  return text + fmt::format(R"(_breccia() {{
  local curcontext=$curcontext state line
  local -a commands
  _arguments -C \
{}    '1: :->command' \
    '*:: :->rest'
  case $state in
    command)
      commands=(
{}      )
      _describe -t commands command commands
      ;;
    rest)
      if (( $+functions[_breccia_$words[1]] )); then _breccia_$words[1]; fi
      ;;
  esac
}}

if [[ $funcstack[1] == _breccia ]]; then
  _breccia "$@"
else
  compdef _breccia breccia
fi
)",
                            options, commands);
}

}  // namespace breccia::cli

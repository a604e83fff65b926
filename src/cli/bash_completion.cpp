#include "cli/bash_completion.hpp"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/command_syntax.hpp"

namespace breccia::cli {
namespace {

constexpr auto bash_helpers = R"(# Completion of breccia for bash: what `breccia completion bash` prints.

# _breccia_words WORDS: those that begin as the word at the cursor.
_breccia_words() {
  COMPREPLY=($(compgen -W "$1" -- "$word"))
}

# _breccia_files [SUFFIX]: directories, and files of this suffix, or all files; a slash stands for directories alone.
_breccia_files() {
  local IFS=$'\n'
  compopt -o filenames 2>/dev/null
  if [[ ${1:-} ]]; then
    COMPREPLY=($(compgen -d -- "$word"; compgen -f -X "!*$1" -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}

_breccia() {
  local word=${COMP_WORDS[COMP_CWORD]}
  COMPREPLY=()
  # The option whose value is completed. To bash the equals signs of --threads=2 and of --material binder=new.toml are
  # words of their own.
  local place=$((COMP_CWORD - 1))
  if [[ $word == = ]]; then word=; ((place += 1)); fi
  while ((place > 1)) && { [[ ${COMP_WORDS[place]} == = ]] ||
    [[ ${COMP_WORDS[place]} != -* && ${COMP_WORDS[place + 1]} == = ]]; }; do
    ((place -= 1))
  done
  local option=${COMP_WORDS[place]} command=
  if ((COMP_CWORD > 1)); then command=${COMP_WORDS[1]}; else option=; fi
)";

std::string completion_of(const ValueSyntax& value) {
  switch (value.kind) {
    case ValueKind::text:
      return {};
    case ValueKind::word:
      return fmt::format("_breccia_words '{}'", fmt::join(value.words, " "));
    case ValueKind::directory:
      return "_breccia_files /";
    case ValueKind::file:
      return fmt::format("_breccia_files{}{}", value.suffix.empty() ? "" : " ", value.suffix);
  }
  return {};
}

/// The branch of a command: the values of its options, then the options and the argument.
std::string branch_of(const CommandSyntax& command, const std::string& pattern) {
  std::string text = fmt::format("    {})\n      case $option in\n", pattern);
  std::vector<std::string> names;
  for (const auto& option : command.options) {
    const auto& name = option.names.back();
    names.push_back(name);
    if (option.values.empty()) continue;
    text += fmt::format("        {}) {};;\n", name, [&] {
      const auto completion = completion_of(option.values.front());
      return completion.empty() ? completion : completion + " ";
    }());
  }
  const auto argument = command.arguments.empty() ? "" : completion_of(command.arguments.front());
  text += fmt::format("        *)\n          if [[ $word == -* ]]; then\n            _breccia_words '{}'\n",
                      fmt::join(names, " "));
  if (!argument.empty()) text += fmt::format("          else\n            {}\n", argument);
  return text + "          fi\n          ;;\n      esac\n      ;;\n";
}

}  // namespace

std::string bash_completion(const CLI::App& application) {
  std::string text = bash_helpers;
  text += "  case $command in\n";
  text += branch_of(syntax_of_program(application), "''");
  for (const auto& command : syntax_of_commands(application)) text += branch_of(command, command.name);
  return text + "  esac\n}\n\ncomplete -F _breccia breccia\n";
}

}  // namespace breccia::cli

#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace breccia::cli {

/// The kind of text that may stand for a value on the command line.
enum class ValueKind {
  text,       ///< a number, a quantity or a name, which no shell can guess
  word,       ///< one of several words
  directory,  ///< a directory
  file        ///< a file, perhaps of one suffix alone
};

/// A value of an option, or an argument.
struct ValueSyntax {
  std::string name;  ///< name in the help, such as DECK or TIME
  ValueKind kind = ValueKind::text;
  std::vector<std::string> words = {};  ///< the words of ValueKind::word
  std::string suffix = {};              ///< suffix of ValueKind::file, such as .toml; empty: any file
};

struct OptionSyntax {
  std::vector<std::string> names;        ///< names with their dashes: -h, --help
  std::string summary;                   ///< description of the option, without defaults and examples
  std::vector<ValueSyntax> values = {};  ///< values of the option; none for a flag
  bool is_repeatable = false;
};

struct CommandSyntax {
  std::string name;
  std::string summary;
  std::vector<OptionSyntax> options;
  std::vector<ValueSyntax> arguments;
};

/// The options of the program itself, with its commands as the words of its one argument.
CommandSyntax syntax_of_program(const CLI::App& application);

/// The commands of the program, in the order of its help.
std::vector<CommandSyntax> syntax_of_commands(const CLI::App& application);

}  // namespace breccia::cli

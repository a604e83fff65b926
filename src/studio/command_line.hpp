#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace breccia::studio {

/// A `breccia` command: what the studio does is done by one, which a user could type.
struct Command {
  std::vector<std::string> arguments = {};  ///< after the name of the program: "check", "a.toml"
  std::vector<std::string> hidden = {};     ///< further arguments that no user needs, such as a place for previews
};

/// The line that a user would type: `breccia check 'my deck.toml'`.
std::string shown(const Command& command);

/// The line with which a user copies a file.
std::string copying_command(std::string_view from, std::string_view to);

/// The line with which a user opens a file in the program that is there for it.
std::string opening_command(std::string_view file);

/// A word as a shell takes it, in quotes where it needs them.
std::string shell_word(std::string_view word);

/// What a command has printed, and how it ended.
struct FinishedCommand {
  int exit_code = 0;
  std::string output = {};
};

/// A mistake in a deck, from a line `a.toml:12:3: message`.
struct ShownMistake {
  int line = 0;  ///< 0: none
  int column = 0;
  std::string message = {};
};

/// The mistakes among the lines that a command has printed about a deck.
std::vector<ShownMistake> mistakes_in(std::string_view output, std::string_view deck);

/// The message with which a command has failed, from all that it has printed: the lines at the end that are no part of
/// a summary, a plan or a table.
std::string failure_in(std::string_view output);

}  // namespace breccia::studio

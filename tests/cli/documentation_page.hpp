#pragma once

#include <map>
#include <string>
#include <vector>

namespace breccia::test {

/// A command of the documentation, and the output that the page quotes.
struct DocumentedCommand {
  std::vector<std::string> arguments;  ///< arguments, without the name of the program
  std::vector<std::string> output;     ///< lines of the output; empty where the page quotes none
};

/// A page of the documentation with files for its reader to write and commands to run.
struct DocumentationPage {
  /// Files by name: blocks of text after a paragraph that names a file first.
  std::map<std::string, std::string> files;
  std::vector<DocumentedCommand> commands;  ///< all commands of the program, in order
};

/// Reads a page of Markdown. The first block without a language after a block of commands is the output of the last
/// command in it.
DocumentationPage read_documentation(const std::string& markdown);

/// A line in which wall times and speeds, which differ from one run to the next, are replaced by dashes.
std::string without_times(const std::string& line);

}  // namespace breccia::test

#include "documentation_page.hpp"

#include <filesystem>
#include <regex>
#include <sstream>
#include <utility>

namespace breccia::test {
namespace {

/// The words of a line of a shell script, up to a comment.
std::vector<std::string> shell_words(const std::string& line) {
  std::vector<std::string> words;
  std::string word;
  bool is_word = false;
  char quote = '\0';
  for (const char letter : line) {
    const bool is_quote = letter == '\'' || letter == '"';
    if (quote != '\0' ? letter == quote : is_quote) {
      quote = quote != '\0' ? '\0' : letter;
      is_word = true;
    } else if (quote == '\0' && letter == '#' && !is_word) {
      break;
    } else if (quote == '\0' && letter == ' ') {
      if (is_word) words.push_back(std::exchange(word, {}));
      is_word = false;
    } else {
      word += letter;
      is_word = true;
    }
  }
  if (is_word) words.push_back(word);
  return words;
}

/// The commands of the program in a block; continued lines are joined.
std::vector<DocumentedCommand> commands_in(const std::string& block) {
  std::vector<DocumentedCommand> commands;
  std::istringstream lines(std::regex_replace(block, std::regex("\\\\\n"), " "));
  for (std::string line; std::getline(lines, line);) {
    auto words = shell_words(line);
    if (words.empty() || std::filesystem::path(words.front()).filename() != "breccia") continue;
    words.erase(words.begin());
    commands.push_back({std::move(words), {}});
  }
  return commands;
}

std::vector<std::string> lines_of(const std::string& block) {
  std::vector<std::string> lines;
  std::istringstream stream(block);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The file that a paragraph names first; empty if it names none.
std::string named_file(const std::string& paragraph) {
  std::smatch found;
  return std::regex_search(paragraph, found, std::regex("`([a-z]+\\.(csv|toml))`")) ? found[1].str() : "";
}

}  // namespace

DocumentationPage read_documentation(const std::string& markdown) {
  DocumentationPage page;
  bool expects_output = false;
  std::string paragraph;  // the last paragraph
  bool has_ended = false;
  std::istringstream lines(markdown);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("```")) {
      if (has_ended && !line.empty()) paragraph.clear();
      has_ended = line.empty();
      if (!line.empty()) paragraph += line + "\n";
      continue;
    }
    std::string block;
    for (std::string inside; std::getline(lines, inside) && inside != "```";) block += inside + "\n";
    const auto language = line.substr(3);
    if (language == "sh") {
      const auto commands = commands_in(block);
      page.commands.insert(page.commands.end(), commands.begin(), commands.end());
      expects_output = !commands.empty();
    } else if (language.empty() && std::exchange(expects_output, false)) {
      page.commands.back().output = lines_of(block);
    } else if (const auto file = named_file(paragraph); !file.empty()) {
      page.files[file] = block;
    }
    has_ended = true;
  }
  return page;
}

std::string without_times(const std::string& line) {
  static const std::regex times(
      "packed in [^ ]+ s|[^ ]+ s for all loads|(snapshots|solves), [^ ]+ s|[^ ]+ s, [^ ]+ million points x steps/s|"
      "about [^ ]+ [a-z]+ at [^ ]+ million points x steps/s|together about [^ ]+ [a-z]+");
  return std::regex_replace(line, times, "---");
}

}  // namespace breccia::test

#include "studio/command_line.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace breccia::studio {
namespace {

/// Takes a whole number and a colon off the beginning of a text; without one both stay as they are.
bool take_number(std::string_view& text, int& number) {
  const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto length = static_cast<std::size_t>(rest - text.data());
  if (failure != std::errc() || !text.substr(length).starts_with(":")) return false;
  text.remove_prefix(length + 1);
  return true;
}

}  // namespace

std::string shell_word(std::string_view word) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos) return std::string(word);
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

std::string shown(const Command& command) {
  std::string line = "breccia";
  for (const auto& argument : command.arguments) line += fmt::format(" {}", shell_word(argument));
  return line;
}

std::string copying_command(std::string_view from, std::string_view to) {
  return fmt::format("cp {} {}", shell_word(from), shell_word(to));
}

std::string opening_command(std::string_view file) {
  return fmt::format("xdg-open {}", shell_word(file));
}

std::string failure_in(std::string_view output) {
  const auto is_of_plan = [](const std::string& line) {
    constexpr std::array<std::string_view, 4> beginnings = {" ", "plan, ", "together ", "warning: "};
    return line.empty() || std::ranges::any_of(beginnings, [&](auto beginning) { return line.starts_with(beginning); });
  };
  std::istringstream lines{std::string(output)};
  std::string failure;
  for (std::string line; std::getline(lines, line);) {
    if (is_of_plan(line)) {
      failure.clear();
    } else {
      if (!failure.empty()) failure += '\n';
      failure += line;
    }
  }
  return failure;
}

std::vector<ShownMistake> mistakes_in(std::string_view output, std::string_view deck) {
  std::vector<ShownMistake> mistakes;
  std::istringstream lines{std::string(output)};
  const auto begin = fmt::format("{}:", deck);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(begin)) continue;
    std::string_view rest = line;
    rest.remove_prefix(begin.size());
    ShownMistake mistake;
    if (take_number(rest, mistake.line)) take_number(rest, mistake.column);
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    mistake.message = rest;
    mistakes.push_back(std::move(mistake));
  }
  return mistakes;
}

}  // namespace breccia::studio

#include "breccia/deckfile/deck_setting.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/printable.hpp"

namespace breccia {

namespace {

bool is_control(char letter) {
  return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
}

std::string escaped(char letter) {
  return fmt::format("\\u{:04x}", static_cast<int>(letter));
}

std::string line_of(const std::filesystem::path& deck, const Mistake& mistake) {
  const auto& location = mistake.location;
  if (!location.option.empty()) return fmt::format("{}: {}", location.option, mistake.message);
  return fmt::format("{}:{}:{}: {}", deck.string(), location.line, location.column, mistake.message);
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') result += '\\';
    result += is_control(letter) ? escaped(letter) : std::string(1, letter);
  }
  return result + "\"";
}

struct TomlText {
  std::string operator()(bool value) const { return fmt::format("{}", value); }
  std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
  std::string operator()(double value) const {
    const auto text = fmt::format("{}", value);
    const bool looks_whole = text.find_first_not_of("-0123456789") == std::string::npos;
    return looks_whole ? text + ".0" : text;
  }
  std::string operator()(const std::string& value) const { return quoted(value); }
};

}  // namespace

void refuse_mistakes(const std::filesystem::path& deck, std::vector<Mistake> mistakes) {
  if (mistakes.empty()) return;
  std::ranges::stable_sort(mistakes, {}, [](const Mistake& mistake) {
    const auto& location = mistake.location;
    return std::tuple(!location.option.empty(), location.line, location.column);
  });
  std::vector<std::string> lines;
  std::set<std::string> known;
  for (const auto& mistake : mistakes) {
    const auto line = printable(line_of(deck, mistake));
    if (known.insert(line).second) lines.push_back(line);
  }
  throw InputError(fmt::format("{}", fmt::join(lines, "\n")));
}

std::string toml_text(const Scalar& value) {
  return std::visit(TomlText(), value);
}

std::string plain_text(const Scalar& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : std::visit([](const auto& plain) { return fmt::format("{}", plain); }, value);
}

std::optional<std::vector<std::string>> split_path(std::string_view path) {
  std::vector<std::string> steps(1);
  bool quoted = false;
  for (const char letter : path) {
    if (letter == '"') {
      quoted = !quoted;
    } else if (letter == '.' && !quoted) {
      if (steps.back().empty()) return std::nullopt;
      steps.emplace_back();
    } else if (quoted || letter != ' ') {
      steps.back() += letter;
    }
  }
  constexpr std::size_t most_steps = 100;  // each step nests one more table
  if (quoted || steps.back().empty() || steps.size() > most_steps) return std::nullopt;
  return steps;
}

}  // namespace breccia

#include "io/file_mistakes.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/printable.hpp"

namespace breccia {

namespace {

constexpr std::size_t most_of_a_kind = 3;
constexpr std::size_t most_kinds = 20;

}  // namespace

FileMistakes::FileMistakes(const std::filesystem::path& file) : file_(file.string()) {}

void FileMistakes::add(std::string_view location, std::string_view expected, std::string_view got) {
  auto kind = std::ranges::find(kinds_, expected, &Kind::expected);
  if (kind == kinds_.end() && kinds_.size() == most_kinds) {
    ++others_;
    return;
  }
  if (kind == kinds_.end()) kind = kinds_.insert(kinds_.end(), Kind{std::string(expected), 0});
  if (++kind->count > most_of_a_kind) return;
  const auto end = got.empty() ? "" : fmt::format(", got {}", got);
  lines_.push_back(printable(fmt::format("{}: {}{}", location.empty() ? file_ : location, expected, end)));
}

void FileMistakes::refuse() const {
  if (empty()) return;
  auto lines = lines_;
  for (const auto& kind : kinds_) {
    if (kind.count <= most_of_a_kind) continue;
    lines.push_back(
        printable(fmt::format("{}: ... {} more like these: {}", file_, kind.count - most_of_a_kind, kind.expected)));
  }
  if (others_ > 0) lines.push_back(fmt::format("{}: ... {} more", printable(file_), others_));
  throw InputError(fmt::format("{}", fmt::join(lines, "\n")));
}

std::string shown_value(std::string_view text) {
  constexpr std::size_t longest = 60;
  if (text.empty()) return "nothing";
  if (text.size() <= longest) return fmt::format("\"{}\"", printable(text));
  auto end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80) --end;  // not within a character
  return fmt::format("\"{}...\"", printable(text.substr(0, end)));
}

}  // namespace breccia

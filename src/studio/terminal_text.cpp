#include "studio/terminal_text.hpp"

#include <charconv>
#include <cstddef>

namespace breccia::studio {
namespace {

constexpr char escape = '\x1b';

/// Whether a control sequence of a terminal, such as "\x1b[K", is complete.
bool is_complete(std::string_view sequence) {
  if (sequence.size() < 2) return false;
  if (sequence[1] != '[') return true;
  const char last = sequence.back();
  return sequence.size() > 2 && last >= '@' && last <= '~';
}

}  // namespace

void TerminalText::add(std::string_view bytes) {
  for (const char byte : bytes) {
    if (!escape_.empty()) {
      escape_ += byte;
      if (escape_ == "\x1b[K") live_.clear();
      if (is_complete(escape_)) escape_.clear();
    } else if (byte == escape) {
      escape_ = byte;
    } else if (byte == '\r') {
      has_returned_ = true;
    } else if (byte == '\n') {
      has_returned_ = false;
      lines_ += live_ + '\n';
      live_.clear();
    } else {
      // What follows a return replaces the line.
      if (has_returned_) live_.clear();
      has_returned_ = false;
      live_ += byte;
    }
  }
}

void TerminalText::finish() {
  if (!live_.empty()) add("\n");
}

std::optional<double> share_in(std::string_view line) {
  const auto end = line.find(" %, ");
  if (end == std::string_view::npos) return std::nullopt;
  auto begin = end;
  while (begin > 0 && line[begin - 1] >= '0' && line[begin - 1] <= '9') --begin;
  int percent = 0;
  const auto [rest, failure] = std::from_chars(line.data() + begin, line.data() + end, percent);
  if (failure != std::errc() || percent < 0 || percent > 100) return std::nullopt;
  return percent / 100.0;
}

}  // namespace breccia::studio

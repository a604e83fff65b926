#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breccia::studio {

/// What a command writes to its terminal: lines that stay, and one live line at the end that it writes again and again
/// (cli::ProgressLine).
class TerminalText {
 public:
  /// Takes some bytes, which may end within a line.
  void add(std::string_view bytes);

  /// All lines that stay, each with its end.
  [[nodiscard]] const std::string& lines() const noexcept { return lines_; }
  /// The line at the end that is not complete; empty without one.
  [[nodiscard]] const std::string& live_line() const noexcept { return live_; }
  /// Makes a last line without an end one that stays: the command has ended.
  void finish();

 private:
  std::string lines_;
  std::string live_;
  std::string escape_;  ///< a control sequence that has begun
  bool has_returned_ = false;
};

/// The share, from 0 to 1, in a line of progress such as "composite, 64 cells: 45 %, snapshot 4"; nothing in other
/// lines.
std::optional<double> share_in(std::string_view line);

}  // namespace breccia::studio

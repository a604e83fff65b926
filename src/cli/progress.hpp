#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace breccia::cli {

/// What a running computation tells: one live line on a terminal, a plain line now and then elsewhere, nothing if
/// quiet.
class Progress {
 public:
  explicit Progress(bool quiet);

  /// Replaces the live line; called as often as one likes.
  void update(std::string_view what, double share, std::string_view details);
  /// A line that stays.
  void print(std::string_view line);
  /// Prints a line that nobody should miss, on standard error, even when quiet.
  void note(std::string_view line);

 private:
  using Clock = std::chrono::steady_clock;

  bool quiet_;
  bool terminal_;
  std::string running_;      ///< what the present live line is about
  Clock::time_point begun_;  ///< when that began
  Clock::time_point shown_;  ///< when the line was last shown
  bool line_is_live_ = false;
};

}  // namespace breccia::cli

#pragma once

#include <chrono>
#include <cstdio>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "heartbeat.hpp"

namespace breccia::cli {

/// What a running computation tells: one live line on a terminal, elsewhere a plain line every minute, nothing if
/// quiet. The lines come from a thread of their own, so that a computation that is silent for long is seen to go on.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;
  /// When lines on what is running come.
  struct Pace {
    Clock::duration pause;           ///< from one line to the next
    std::chrono::milliseconds beat;  ///< between two looks at the clock
  };

  explicit Progress(bool quiet);
  /// Writes the lines on what is running to a stream, which stays open, at another pace than the usual one.
  Progress(bool quiet, std::FILE* stream, const Pace& pace);

  /// What is running now, the share of it that is done, and details; called as often as one likes.
  void update(std::string_view what, double share, std::string_view details);
  /// A line that stays.
  void print(std::string_view line);
  /// Prints a line that nobody should miss, on standard error, even when quiet.
  void note(std::string_view line);

 private:
  struct Running {
    std::string what;
    double share = 0.0;
    std::string details;
    Clock::time_point begun;
  };

  void show();
  void clear_live_line();

  bool quiet_;
  std::FILE* stream_;
  bool terminal_;
  Clock::duration pause_;
  std::mutex mutex_;  ///< for all below, which the heartbeat reads
  Running running_;
  bool is_running_ = false;  ///< something has been told since the last line that stays
  Clock::time_point shown_;  ///< when a line was last shown
  bool line_is_live_ = false;
  std::optional<Heartbeat> heartbeat_;  ///< last, so that it ends before what it reads
};

}  // namespace breccia::cli

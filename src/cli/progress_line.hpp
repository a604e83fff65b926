#pragma once

#include <chrono>
#include <cstdio>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "cli/heartbeat.hpp"

namespace breccia::cli {

/// Prints the progress of a computation: one line that is updated on a terminal, elsewhere a plain line every minute,
/// nothing if quiet. A separate thread prints the lines, so that they also appear during long steps.
class ProgressLine {
 public:
  using Clock = std::chrono::steady_clock;
  /// The timing of progress lines.
  struct Pace {
    Clock::duration pause;           ///< time between two lines
    std::chrono::milliseconds beat;  ///< time between two checks of the clock
  };

  explicit ProgressLine(bool quiet);
  /// Writes progress lines to a stream, which is not closed, with the given timing.
  ProgressLine(bool quiet, std::FILE* stream, const Pace& pace);
  /// Removes the line from a terminal.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ProgressLine(ProgressLine&&) = delete;
  ProgressLine& operator=(ProgressLine&&) = delete;

  /// Sets the running work, its finished share (0 to 1) and details; may be called as often as needed.
  void update(std::string_view what, double share, std::string_view details);
  /// Prints a permanent line.
  void print(std::string_view line);
  /// Prints an important line on standard error, even when quiet.
  void note(std::string_view line);
  /// Prints a warning, "warning: ...", unless it was printed before: on standard error when quiet.
  void warn(const std::string& warning);

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
  std::mutex mutex_;  ///< protects all members below, which the heartbeat reads
  Running running_;
  bool is_running_ = false;  ///< whether update() was called after the last permanent line
  Clock::time_point shown_;  ///< time at which a line was last shown
  bool line_is_live_ = false;
  std::set<std::string> warnings_;      ///< those that were printed
  std::optional<Heartbeat> heartbeat_;  ///< last member, so that it ends before the members that it reads
};

}  // namespace breccia::cli

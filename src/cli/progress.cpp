#include "progress.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace breccia::cli {
namespace {

std::string duration(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0), begun_(Clock::now()) {}

void Progress::update(std::string_view what, double share, std::string_view details) {
  if (quiet_) return;
  const auto now = Clock::now();
  if (running_ != what) {
    running_ = what;
    begun_ = shown_ = now;
  }
  const auto pause = terminal_ ? std::chrono::milliseconds(200) : std::chrono::seconds(15);
  if (now - shown_ < pause) return;
  shown_ = now;
  const double elapsed = std::chrono::duration<double>(now - begun_).count();
  constexpr double enough_to_tell = 0.02;
  const auto left = share > enough_to_tell ? fmt::format(", {} left", duration(elapsed * (1.0 - share) / share)) : "";
  const auto line = fmt::format("{}: {:3.0f} %, {}{}", what, 100.0 * share, details, left);
  if (terminal_) {
    fmt::print(stderr, "\r\x1b[K{}", line);
    line_is_live_ = true;
  } else {
    fmt::print(stderr, "{}\n", line);
  }
  (void)std::fflush(stderr);
}

void Progress::print(std::string_view line) {
  if (quiet_) return;
  if (line_is_live_) fmt::print(stderr, "\r\x1b[K");
  line_is_live_ = false;
  (void)std::fflush(stderr);
  fmt::print("{}\n", line);
  (void)std::fflush(stdout);
}

void Progress::note(std::string_view line) {
  if (line_is_live_) fmt::print(stderr, "\r\x1b[K");
  line_is_live_ = false;
  fmt::print(stderr, "{}\n", line);
  (void)std::fflush(stderr);
}

}  // namespace breccia::cli

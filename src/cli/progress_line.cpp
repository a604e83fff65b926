#include "cli/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "io/display.hpp"

namespace breccia::cli {
namespace {

using std::chrono::milliseconds;

bool is_terminal(std::FILE* stream) {
  return isatty(fileno(stream)) != 0;
}

ProgressLine::Pace usual_pace() {
  return is_terminal(stderr) ? ProgressLine::Pace{milliseconds(0), milliseconds(250)}
                             : ProgressLine::Pace{std::chrono::minutes(1), milliseconds(5000)};
}

}  // namespace

ProgressLine::ProgressLine(bool quiet) : ProgressLine(quiet, stderr, usual_pace()) {}

ProgressLine::ProgressLine(bool quiet, std::FILE* stream, const Pace& pace)
    : quiet_(quiet), stream_(stream), terminal_(is_terminal(stream)), pause_(pace.pause), shown_(Clock::now()) {
  if (!quiet) heartbeat_.emplace(pace.beat, [this] { show(); });
}

ProgressLine::~ProgressLine() {
  heartbeat_.reset();
  clear_live_line();
}

void ProgressLine::update(std::string_view what, double share, std::string_view details) {
  if (quiet_) return;
  const std::lock_guard lock(mutex_);
  if (running_.what != what) {
    running_.what = what;
    running_.begun = Clock::now();
  }
  running_.share = share;
  running_.details = details;
  is_running_ = true;
}

/// Prints a line about the running work, if it is due; called by the heartbeat.
void ProgressLine::show() {
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (!is_running_ || now - shown_ < pause_ || now - running_.begun < pause_) return;
  shown_ = now;
  const double elapsed = std::chrono::duration<double>(now - running_.begun).count();
  constexpr double enough_to_tell = 0.02;
  const double share = running_.share;
  const bool can_tell = share > enough_to_tell && share < 1.0;
  const auto left = can_tell ? fmt::format(", {} left", display_duration(elapsed * (1.0 - share) / share)) : "";
  const auto line = fmt::format("{}: {:.0f} %, {}, {} so far{}", running_.what, 100.0 * share, running_.details,
                                display_duration(elapsed), left);
  // A progress line that cannot be printed is no reason to end the computation.
  (void)std::fputs((terminal_ ? "\r\x1b[K" + line : line + "\n").c_str(), stream_);
  (void)std::fflush(stream_);
  line_is_live_ = terminal_;
}

void ProgressLine::clear_live_line() {
  if (line_is_live_) (void)std::fputs("\r\x1b[K", stream_);
  (void)std::fflush(stream_);
  line_is_live_ = false;
}

void ProgressLine::print(std::string_view line) {
  if (quiet_) return;
  const std::lock_guard lock(mutex_);
  clear_live_line();
  is_running_ = false;
  shown_ = Clock::now();
  fmt::print("{}\n", line);
  (void)std::fflush(stdout);
}

void ProgressLine::warn(const std::string& warning) {
  if (!warnings_.insert(warning).second) return;
  if (quiet_) return note("warning: " + warning);
  print("warning: " + warning);
}

void ProgressLine::note(std::string_view line) {
  const std::lock_guard lock(mutex_);
  clear_live_line();
  fmt::print(stderr, "{}\n", line);
  (void)std::fflush(stderr);
}

}  // namespace breccia::cli

#include "cli/interruption.hpp"

#include <cerrno>
#include <csignal>
#include <ctime>
#include <string_view>

#include <unistd.h>

#include "breccia/error.hpp"

#include "parallel/session.hpp"

namespace breccia::cli {
namespace {

// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
volatile std::sig_atomic_t requested = 0;
volatile std::sig_atomic_t speaks = 0;  ///< whether a user at a terminal reads what is written
std::timespec first_request = {};
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

constexpr std::string_view notice =
    "\nStopping as soon as what has been computed is saved; Ctrl-C again stops at once, and a run then goes on from "
    "its "
    "last checkpoint with --resume.\n";

/// The time since the first request [s].
double seconds_since_request() {
  std::timespec now = {};
  (void)::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec - first_request.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - first_request.tv_nsec);
}

/// Calls nothing but what a signal handler may call.
extern "C" void request_stop(int signal) {
  const int error = errno;
  if (requested == 0) {
    (void)::clock_gettime(CLOCK_MONOTONIC, &first_request);
    requested = 1;
    if (speaks != 0) (void)!::write(STDERR_FILENO, notice.data(), notice.size());
    errno = error;
    return;
  }
  // One key may send several signals, to a program and to its parent, which passes them on.
  constexpr double of_one_key = 0.5;
  if (signal != SIGINT || speaks == 0 || seconds_since_request() < of_one_key) return;
  (void)std::signal(SIGINT, SIG_DFL);
  (void)std::raise(SIGINT);
}

}  // namespace

void watch_for_interruption() {
  speaks = parallel::is_alone() && ::isatty(STDERR_FILENO) == 1 ? 1 : 0;
  // The result is ignored: a handler can be set for these signals on every system.
  (void)std::signal(SIGINT, request_stop);
  (void)std::signal(SIGTERM, request_stop);
  // A command that nohup started ignores the end of its terminal.
  if (std::signal(SIGHUP, request_stop) == SIG_IGN) (void)std::signal(SIGHUP, SIG_IGN);
}

bool interruption_requested() {
  return requested != 0;
}

void stop_if_interrupted() {
  if (interruption_requested()) throw Interrupted("interrupted; finished results are kept");
}

}  // namespace breccia::cli

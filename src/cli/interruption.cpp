#include "cli/interruption.hpp"

#include <csignal>

#include "breccia/error.hpp"

namespace breccia::cli {
namespace {

volatile std::sig_atomic_t requested = 0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

extern "C" void request_stop(int /*signal*/) {
  requested = 1;
}

}  // namespace

void watch_for_interruption() {
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

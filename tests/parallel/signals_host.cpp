// A program with its own handlers of signals, which the library leaves in place when it starts MPI and PETSc and when
// it divides the processes, for which it starts PETSc anew.

#include <array>
#include <csignal>
#include <cstdio>

#include "parallel/session.hpp"

namespace {

constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP, SIGFPE, SIGUSR1};

extern "C" void handle(int /*signal*/) {}

bool are_handled(const char* when) {
  bool are_all_handled = true;
  for (const int signal : signals) {
    if (std::signal(signal, handle) == handle) continue;
    std::printf("%s: the library has taken over signal %d\n", when, signal);
    are_all_handled = false;
  }
  return are_all_handled;
}

}  // namespace

int main() {
  for (const int signal : signals) (void)std::signal(signal, handle);
  breccia::parallel::start();
  const bool after_start = are_handled("started");
  breccia::parallel::divide(1);
  const bool after_division = are_handled("divided");
  breccia::parallel::stop();
  return after_start && after_division && are_handled("stopped") ? 0 : 1;
}

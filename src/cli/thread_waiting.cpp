#include "cli/thread_waiting.hpp"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace breccia::cli {

void have_threads_sleep_soon(char** arguments) {
  constexpr auto rounds_before_sleep = "GOMP_SPINCOUNT";
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv(rounds_before_sleep) != nullptr) return;
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const bool is_breccia = !error && program.filename().string().starts_with("breccia");  // not a loader or an emulator
  if (!is_breccia || setenv(rounds_before_sleep, "1000", 0) != 0) return;
  execv(program.c_str(), arguments);
}

}  // namespace breccia::cli

#include "cli/browser.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/text_file.hpp"

namespace breccia::cli {
namespace {

bool is_on_a_desktop() {
  return ::isatty(STDOUT_FILENO) == 1 &&
         (std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr);
}

}  // namespace

void show_in_browser(const std::string& address, const std::filesystem::path& private_directory) {
  if (!is_on_a_desktop()) return;
  auto page = (private_directory / "open.html").string();
  write_text(page, fmt::format(R"(<!doctype html><meta charset="utf-8"><title>Breccia studio</title>
<meta http-equiv="refresh" content="0; url={0}"><p><a href="{0}">Breccia studio</a></p>
)",
                               address));
  std::string opener = "xdg-open";
  const std::array<char*, 3> arguments = {opener.data(), page.data(), nullptr};
  posix_spawn_file_actions_t silent;
  posix_spawn_file_actions_init(&silent);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&silent, stream, "/dev/null", O_WRONLY, 0);
  }
  // In a session of its own, so that the keys of this terminal do not reach the browser, and with the usual signals.
  posix_spawnattr_t apart;
  posix_spawnattr_init(&apart);
  sigset_t all;
  sigfillset(&all);
  posix_spawnattr_setsigdefault(&apart, &all);
  posix_spawnattr_setflags(&apart, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGDEF);
  pid_t process = 0;
  // Without such a program the address that was printed does.
  const bool has_begun = ::posix_spawnp(&process, opener.c_str(), &silent, &apart, arguments.data(), environ) == 0;
  posix_spawnattr_destroy(&apart);
  posix_spawn_file_actions_destroy(&silent);
  // Waits for its end, whenever that is.
  if (has_begun) std::thread([process] { (void)::waitpid(process, nullptr, 0); }).detach();
}

}  // namespace breccia::cli

#include "studio/child_process.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

#include <fmt/format.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "breccia/error.hpp"

namespace breccia::studio {
namespace {

constexpr int unknown_code = 255;

/// Becomes the program, in a process that has just been made: calls nothing but what such a process may call.
[[noreturn]] void become(char* const* arguments, const char* directory) {
  constexpr int cannot_start = 127;
  // A terminal of its own gives the program the usual answer to each of these.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) (void)std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  constexpr int first_of_others = 3, most = 4096;
  // Old kernels, and some containers, have no such call.
  if (close_range(first_of_others, ~0U, 0) != 0) {
    for (int file = first_of_others; file < most; ++file) (void)::close(file);
  }
  if (::chdir(directory) == 0) ::execv(arguments[0], arguments);
  constexpr std::string_view message = "the program cannot be started in this folder\n";
  (void)!::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(cannot_start);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments, const std::filesystem::path& directory) {
  std::vector<std::string> texts = arguments;
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (auto& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  const auto where = directory.string();
  constexpr unsigned short rows = 50, columns = 120;
  const winsize size = {rows, columns, 0, 0};
  process_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
  if (process_ == 0) become(pointers.data(), where.c_str());
  if (process_ < 0) throw FileError(fmt::format("{}: cannot start: {}", texts.front(), std::strerror(errno)));
}

ChildProcess::~ChildProcess() {
  send(SIGKILL);
  (void)exit_code();
  (void)::close(terminal_);
}

std::optional<std::string> ChildProcess::read(std::chrono::milliseconds wait) {
  pollfd ready = {terminal_, POLLIN, 0};
  if (::poll(&ready, 1, static_cast<int>(wait.count())) == 0) return "";
  std::array<char, 1 << 16> bytes = {};
  const auto count = ::read(terminal_, bytes.data(), bytes.size());
  if (count > 0) return std::string(bytes.data(), static_cast<std::size_t>(count));
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return "";
  return std::nullopt;  // the end: the other side of the terminal is closed
}

int ChildProcess::exit_code() {
  // Waits without giving the number of the process free.
  siginfo_t information = {};
  while (::waitid(P_PID, static_cast<id_t>(process_), &information, WEXITED | WNOWAIT) != 0 && errno == EINTR) continue;
  const std::lock_guard lock(mutex_);
  if (!exit_code_) {
    int status = 0;
    const bool is_known = ::waitpid(process_, &status, 0) == process_;
    constexpr int of_signals = 128;
    exit_code_ = !is_known ? unknown_code : WIFEXITED(status) ? WEXITSTATUS(status) : of_signals + WTERMSIG(status);
  }
  return *exit_code_;
}

void ChildProcess::send(int signal) noexcept {
  const std::lock_guard lock(mutex_);
  if (exit_code_) return;
  // The process leads a group of its own as soon as it has begun.
  if (::kill(-process_, signal) != 0) (void)::kill(process_, signal);
}

}  // namespace breccia::studio

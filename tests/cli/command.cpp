#include "command.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <iterator>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/text_file.hpp"

namespace breccia::test {

namespace {

/// Starts the command in a process group of its own; its streams are the files stdout and stderr of the directory.
pid_t start(const std::filesystem::path& directory, std::vector<std::string> words) {
  words.insert(words.begin(), BRECCIA_COMMAND);
  std::vector<char*> pointers;
  std::ranges::transform(words, std::back_inserter(pointers), [](std::string& word) { return word.data(); });
  pointers.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "stdout", flags, 0644);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "stderr", flags, 0644);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  pid_t process = 0;
  const int failure = posix_spawn(&process, BRECCIA_COMMAND, &actions, &attributes, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (failure != 0) throw std::runtime_error("cannot run " BRECCIA_COMMAND);
  return process;
}

}  // namespace

RunningCommand::RunningCommand(std::filesystem::path directory, const std::vector<std::string>& arguments)
    : directory_(std::move(directory)), process_(start(directory_, arguments)) {}

RunningCommand::~RunningCommand() {
  if (has_ended()) return;
  send(SIGKILL);
  waitpid(process_, &status_, 0);
}

bool RunningCommand::has_ended() {
  if (!ended_) ended_ = waitpid(process_, &status_, WNOHANG) != 0;
  return ended_;
}

bool RunningCommand::reaches(const std::function<bool()>& condition) {
  while (!condition()) {
    if (has_ended()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

void RunningCommand::send(int signal) const {
  kill(-process_, signal);
}

Outcome RunningCommand::wait() {
  while (!ended_) ended_ = waitpid(process_, &status_, 0) == process_ || errno != EINTR;
  return {WIFEXITED(status_) ? WEXITSTATUS(status_) : -1, read_text(directory_ / "stdout"),
          read_text(directory_ / "stderr")};
}

Outcome run_breccia(const std::filesystem::path& directory, const std::vector<std::string>& arguments) {
  return RunningCommand(directory, arguments).wait();
}

}  // namespace breccia::test

#include "child_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <memory>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "breccia/error.hpp"

namespace breccia {

namespace {

/// A temporary file without a name, for a standard stream. Unlike pipes, files cannot make the two processes wait for
/// each other.
class TemporaryFile {
 public:
  TemporaryFile() : file_(std::tmpfile(), &std::fclose) {
    if (!file_) throw FileError(fmt::format("cannot make a temporary file: {}", std::strerror(errno)));
  }

  [[nodiscard]] int descriptor() const { return fileno(file_.get()); }

  void write(const std::string& text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size();
    if (!written || std::fflush(file_.get()) != 0) {
      throw FileError(fmt::format("cannot write a temporary file: {}", std::strerror(errno)));
    }
    std::rewind(file_.get());
  }

  [[nodiscard]] std::string read() {
    std::rewind(file_.get());
    std::string text;
    std::array<char, 65536> buffer{};
    while (const auto size = std::fread(buffer.data(), 1, buffer.size(), file_.get())) text.append(buffer.data(), size);
    return text;
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

/// The standard streams of a child process.
class Redirections {
 public:
  Redirections() { posix_spawn_file_actions_init(&actions_); }
  ~Redirections() { posix_spawn_file_actions_destroy(&actions_); }
  Redirections(const Redirections&) = delete;
  Redirections& operator=(const Redirections&) = delete;
  Redirections(Redirections&&) = delete;
  Redirections& operator=(Redirections&&) = delete;

  void redirect(int stream, const TemporaryFile& file) {
    posix_spawn_file_actions_adddup2(&actions_, file.descriptor(), stream);
  }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// Puts the child into its own process group, so that an interrupt from the terminal reaches only this program.
class OwnProcessGroup {
 public:
  OwnProcessGroup() {
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  ~OwnProcessGroup() { posix_spawnattr_destroy(&attributes_); }
  OwnProcessGroup(const OwnProcessGroup&) = delete;
  OwnProcessGroup& operator=(const OwnProcessGroup&) = delete;
  OwnProcessGroup(OwnProcessGroup&&) = delete;
  OwnProcessGroup& operator=(OwnProcessGroup&&) = delete;

  [[nodiscard]] const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) throw FileError(fmt::format("cannot wait for a child process: {}", std::strerror(errno)));
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

ProcessResult run_program(const std::vector<std::string>& command, const std::string& input) {
  TemporaryFile standard_input;
  TemporaryFile standard_output;
  TemporaryFile standard_error;
  standard_input.write(input);

  Redirections streams;
  streams.redirect(STDIN_FILENO, standard_input);
  streams.redirect(STDOUT_FILENO, standard_output);
  streams.redirect(STDERR_FILENO, standard_error);

  auto words = command;
  std::vector<char*> arguments;
  std::ranges::transform(words, std::back_inserter(arguments), [](std::string& word) { return word.data(); });
  arguments.push_back(nullptr);

  const OwnProcessGroup group;
  pid_t process = 0;
  const int failure = posix_spawnp(&process, arguments[0], streams.get(), group.get(), arguments.data(), environ);
  if (failure != 0) throw FileError(fmt::format("cannot run {}: {}", command[0], std::strerror(failure)));
  const int exit_status = wait_for(process);
  return {exit_status, standard_output.read(), standard_error.read()};
}

}  // namespace breccia

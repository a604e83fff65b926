#pragma once

#include <chrono>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace breccia::studio {

/// A program that runs in a terminal of its own, so that it shows its progress as to a person. If this process dies,
/// the terminal ends and the program is asked to stop (SIGHUP).
class ChildProcess {
 public:
  /// Starts a program in a directory. The first argument is its path. Throws FileError if it cannot be started.
  ChildProcess(const std::vector<std::string>& arguments, const std::filesystem::path& directory);
  /// Kills the program if it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ChildProcess(ChildProcess&&) = delete;
  ChildProcess& operator=(ChildProcess&&) = delete;

  /// What the program has written since the last call, after waiting for it at most this long; nothing once it has
  /// ended and all of it was read. For one thread.
  std::optional<std::string> read(std::chrono::milliseconds wait);
  /// The exit code of the program, which has ended (read() returned nothing); 128 + signal if a signal ended it,
  /// 255 if the system does not say.
  int exit_code();
  /// Sends a signal to the program and to all that it has started; from any thread.
  void send(int signal) noexcept;

 private:
  pid_t process_ = 0;
  int terminal_ = -1;
  std::mutex mutex_;  ///< so that no signal goes to another process that has got the number of one that has ended
  std::optional<int> exit_code_;
};

}  // namespace breccia::studio

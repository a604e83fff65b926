#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace breccia::test {

/// Exit code and output of a run of the `breccia` command.
struct Outcome {
  int exit_code = -1;  ///< -1 when a signal ended it
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// A running `breccia` command in a directory. Its standard streams go to files there.
class RunningCommand {
 public:
  RunningCommand(std::filesystem::path directory, const std::vector<std::string>& arguments);
  /// Kills the command if it still runs.
  ~RunningCommand();
  RunningCommand(const RunningCommand&) = delete;
  RunningCommand& operator=(const RunningCommand&) = delete;
  RunningCommand(RunningCommand&&) = delete;
  RunningCommand& operator=(RunningCommand&&) = delete;

  /// Waits until the condition holds. Returns false if the command ends before.
  [[nodiscard]] bool reaches(const std::function<bool()>& condition);
  /// Sends a signal to the command and to the processes that it has started, as a terminal does.
  void send(int signal) const;
  /// Waits until the command ends.
  Outcome wait();

 private:
  [[nodiscard]] bool has_ended();

  std::filesystem::path directory_;
  pid_t process_ = 0;
  int status_ = 0;
  bool ended_ = false;
};

/// Runs `breccia` with these arguments in a directory.
Outcome run_breccia(const std::filesystem::path& directory, const std::vector<std::string>& arguments);

}  // namespace breccia::test

#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "studio/command_runner.hpp"
#include "studio/terminal_text.hpp"

namespace breccia::studio {

enum class RunState { running, done, failed, stopped };

/// A run of a study as a page shows it.
struct RunStatus {
  int id = 0;
  Command command = {};
  std::string deck = {};
  std::filesystem::path results = {};  ///< directory of the results, relative to the folder
  RunState state = RunState::running;
  std::optional<int> exit_code = {};
  std::string output = {};     ///< the lines that stay
  std::string live_line = {};  ///< the line of the progress
  double seconds = 0.0;        ///< since the start, or of the whole run [s]
};

/// The run of a study, one at a time. For several threads.
class RunningStudy {
 public:
  explicit RunningStudy(Program program);
  /// Asks the run to stop and waits until it has saved what it has.
  ~RunningStudy();
  RunningStudy(const RunningStudy&) = delete;
  RunningStudy& operator=(const RunningStudy&) = delete;
  RunningStudy(RunningStudy&&) = delete;
  RunningStudy& operator=(RunningStudy&&) = delete;

  /// Starts a run. Returns false, and does nothing, while another one runs. Throws FileError if it cannot be started.
  bool start(const Command& command, const std::string& deck, const std::filesystem::path& results);
  /// Asks the run to stop at the next suitable point; without one it does nothing.
  void stop();
  /// The run, or the last one; nothing before the first.
  [[nodiscard]] std::optional<RunStatus> status() const;

 private:
  using Clock = std::chrono::steady_clock;

  void follow();

  Program program_;
  mutable std::mutex mutex_;  ///< protects the members below
  std::optional<RunStatus> status_;
  TerminalText text_;
  Clock::time_point begun_;
  std::shared_ptr<ChildProcess> process_;
  std::jthread follower_;  ///< last member, so that it ends first
};

}  // namespace breccia::studio

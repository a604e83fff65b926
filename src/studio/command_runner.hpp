#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "studio/child_process.hpp"
#include "studio/command_line.hpp"

namespace breccia::studio {

/// The program of the studio, and the folder in which it runs its commands.
struct Program {
  std::filesystem::path path = {};
  std::filesystem::path folder = {};

  /// Starts a command.
  [[nodiscard]] std::unique_ptr<ChildProcess> start(const Command& command) const;
};

/// Runs commands of one kind to their end, of which only the answer of the latest counts: one that is started while
/// another one runs ends that one. For several threads.
class LatestCommand {
 public:
  explicit LatestCommand(Program program);

  /// What a command printed; nothing if a later one, or end(), has ended it. Throws FileError if it cannot be started.
  std::optional<FinishedCommand> run(const Command& command);
  /// Ends the command that runs, if there is one, and all that follow.
  void end();

 private:
  Program program_;
  std::mutex mutex_;
  std::shared_ptr<ChildProcess> running_;  ///< null without one
  bool is_closed_ = false;
};

}  // namespace breccia::studio

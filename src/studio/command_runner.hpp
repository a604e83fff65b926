#pragma once

#include <filesystem>
#include <map>
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

/// Runs commands of one kind to their end. Of those about the same deck or file only the answer of the latest counts:
/// one that is started while another one runs ends that one. For several threads.
class LatestCommands {
 public:
  explicit LatestCommands(Program program);

  /// What a command about a deck or file printed; nothing if a later one, or end(), has ended it. Throws FileError if
  /// it cannot be started.
  std::optional<FinishedCommand> run(const std::string& about, const Command& command);
  /// Ends the commands that run and all that follow.
  void end();

 private:
  Program program_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<ChildProcess>> running_;
  bool is_closed_ = false;
};

}  // namespace breccia::studio

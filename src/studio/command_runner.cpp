#include "studio/command_runner.hpp"

#include <chrono>
#include <csignal>
#include <utility>
#include <vector>

#include "studio/terminal_text.hpp"

namespace breccia::studio {

std::unique_ptr<ChildProcess> Program::start(const Command& command) const {
  std::vector<std::string> arguments = {path.string()};
  arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
  arguments.insert(arguments.end(), command.hidden.begin(), command.hidden.end());
  return std::make_unique<ChildProcess>(arguments, folder);
}

LatestCommands::LatestCommands(Program program) : program_(std::move(program)) {}

std::optional<FinishedCommand> LatestCommands::run(const std::string& about, const Command& command) {
  std::shared_ptr<ChildProcess> mine;
  {
    const std::lock_guard lock(mutex_);
    if (is_closed_) return std::nullopt;
    if (const auto earlier = running_.find(about); earlier != running_.end()) earlier->second->send(SIGKILL);
    mine = program_.start(command);
    running_[about] = mine;
  }
  TerminalText text;
  constexpr std::chrono::milliseconds wait(200);
  while (const auto bytes = mine->read(wait)) text.add(*bytes);
  text.finish();
  const int exit_code = mine->exit_code();
  const std::lock_guard lock(mutex_);
  const auto latest = running_.find(about);
  if (latest == running_.end() || latest->second != mine) return std::nullopt;
  running_.erase(latest);
  return FinishedCommand{exit_code, text.lines()};
}

void LatestCommands::end() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  for (const auto& [about, command] : running_) command->send(SIGKILL);
  running_.clear();
}

}  // namespace breccia::studio

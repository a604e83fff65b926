#include "studio/running_study.hpp"

#include <csignal>
#include <utility>

#include "breccia/error.hpp"

namespace breccia::studio {
namespace {

RunState state_after(int exit_code) {
  if (exit_code == static_cast<int>(ExitCode::done)) return RunState::done;
  return exit_code == static_cast<int>(ExitCode::interrupted) ? RunState::stopped : RunState::failed;
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

RunningStudy::RunningStudy(Program program) : program_(std::move(program)) {}

RunningStudy::~RunningStudy() {
  stop();
}

bool RunningStudy::start(const Command& command, const std::string& deck, const std::filesystem::path& results) {
  const std::lock_guard lock(mutex_);
  if (status_ && status_->state == RunState::running) return false;
  const int id = status_ ? status_->id + 1 : 1;
  process_ = program_.start(command);
  status_ = RunStatus{.id = id, .command = command, .deck = deck, .results = results};
  text_ = {};
  begun_ = Clock::now();
  // The follower of an earlier run has nothing left to do, and needs the lock no more.
  follower_ = std::jthread([this] { follow(); });
  return true;
}

void RunningStudy::stop() {
  const std::lock_guard lock(mutex_);
  if (status_ && status_->state == RunState::running) process_->send(SIGINT);
}

std::optional<RunStatus> RunningStudy::status() const {
  const std::lock_guard lock(mutex_);
  if (!status_) return std::nullopt;
  auto now = *status_;
  now.output = text_.lines();
  now.live_line = text_.live_line();
  if (now.state == RunState::running) now.seconds = seconds_since(begun_);
  return now;
}

void RunningStudy::follow() {
  std::shared_ptr<ChildProcess> process;
  {
    const std::lock_guard lock(mutex_);
    process = process_;
  }
  constexpr std::chrono::milliseconds wait(200);
  while (const auto bytes = process->read(wait)) {
    const std::lock_guard lock(mutex_);
    text_.add(*bytes);
  }
  const int exit_code = process->exit_code();
  const std::lock_guard lock(mutex_);
  text_.finish();
  status_->exit_code = exit_code;
  status_->state = state_after(exit_code);
  status_->seconds = seconds_since(begun_);
}

}  // namespace breccia::studio

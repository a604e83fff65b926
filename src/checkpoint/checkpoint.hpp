#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/checkpoint/checkpoint_schedule.hpp"

#include "checkpoint/state.hpp"

namespace breccia {

/// The state of one calculation in a file, so that the calculation can be resumed after it was interrupted, killed or
/// ended by a limit of time. The last but one state is kept, too, until the calculation is finished.
class Checkpoint {
 public:
  Checkpoint(std::filesystem::path path, StateOwner owner, CheckpointSchedule schedule);

  /// Looks for the state that an earlier run has saved. Returns a message for each damaged file, which is set aside,
  /// and for the state used instead. Throws InputError when a state belongs to another deck or version; FileError, on
  /// all processes, when one of them cannot read it.
  std::vector<std::string> look_for_earlier();
  /// The state that was found, of the unfinished calculation or of its result; nullptr if the calculation starts anew.
  [[nodiscard]] const StateReader* earlier() const noexcept { return earlier_ ? &*earlier_ : nullptr; }
  /// Whether earlier() is the result of a finished calculation.
  [[nodiscard]] bool is_finished() const;

  /// Whether the state should be saved now: the same value on all processes, each of which must call the function.
  [[nodiscard]] bool is_due();
  /// Whether the run shall end: the same value on all processes, each of which must call the function.
  [[nodiscard]] bool is_to_end();
  /// Saves the state; then throws Interrupted if the run shall end. Throws FileError, on all processes.
  void save(const WriteState& write);
  /// Saves the result, and removes the last but one state. Throws FileError, on all processes.
  void finish(const WriteState& write);

 private:
  using Clock = std::chrono::steady_clock;

  void put(const WriteState& write, bool is_finished);

  std::filesystem::path path_;
  StateOwner owner_;
  CheckpointSchedule schedule_;
  Clock::time_point last_ = Clock::now();
  bool ends_ = false;
  std::optional<StateReader> earlier_;
};

/// Whether this is the name of a checkpoint file, of the previous checkpoint, or of a damaged one that was set aside.
bool is_checkpoint_file(std::string_view name);

}  // namespace breccia

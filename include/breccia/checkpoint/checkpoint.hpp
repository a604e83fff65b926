#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/checkpoint/state.hpp"

namespace breccia {

/// When a calculation leaves its state.
struct CheckpointSchedule {
  double interval = 600.0;          ///< wall time from one to the next [s]
  std::function<bool()> stop = {};  ///< is the run to end? Asked often, by each process
};

/// The state of one calculation on the disk, so that it can go on after it was interrupted, killed or cut off by a
/// limit of time. The state before the last one is kept, too, until the calculation is done.
class Checkpoint {
 public:
  Checkpoint(std::filesystem::path path, StateOwner owner, CheckpointSchedule schedule);

  /// Looks for what an earlier run has left. Returns what is wrong with files that had to be left aside, and what is
  /// taken instead.
  /// Throws InputError when a state is of another deck or version.
  std::vector<std::string> look_for_earlier();
  /// What was found: of the unfinished calculation, or its result. nullptr: it begins anew.
  [[nodiscard]] const StateReader* earlier() const noexcept { return earlier_ ? &*earlier_ : nullptr; }
  /// Whether that is the result.
  [[nodiscard]] bool is_finished() const;

  /// Is the state to be left now? The same on all processes, each of which must ask.
  [[nodiscard]] bool is_due();
  /// Leaves it. Throws Interrupted thereafter if the run is to end.
  void save(const WriteState& write);
  /// Leaves the result.
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

/// Is this the name of the file of a checkpoint, of the one before it, or of a damaged one that was set aside?
bool is_checkpoint_file(std::string_view name);

}  // namespace breccia

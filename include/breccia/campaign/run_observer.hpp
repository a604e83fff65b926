#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <variant>

#include "breccia/homogenisation/study_event.hpp"
#include "breccia/progress.hpp"

namespace breccia {

struct Sweep;

/// Event: results that will replace earlier ones are written to this directory until they are complete.
struct ResultsKeptBeside {
  const std::filesystem::path& directory;
};

/// Event: another task of a sweep has computed this stage already; its files are in this directory.
struct StageTakenOver {
  const StageResult& stage;
  const std::filesystem::path& directory;
};

/// Event: a stage was computed from the reduced responses of a task of the sweep at another temperature.
struct StageFromResponses {
  const StageResult& stage;
  const std::string& task;
};

/// Event: a message for the user, such as a warning about a damaged file that is not used.
struct Note {
  std::string text;
};

/// Event: a task of a sweep begins.
struct TaskBegun {
  const Sweep& sweep;
  std::size_t task;
};

/// Event: a task of a sweep is complete already and is skipped.
struct TaskSkipped {
  const Sweep& sweep;
  std::size_t task;
};

/// Event: a task of a sweep has failed; the other tasks still run.
struct TaskFailed {
  const Sweep& sweep;
  std::size_t task;
  std::string error;
};

/// An event of the run of a study or a sweep in a directory. Results are written to the disk before the event that
/// reports them.
using RunEvent = std::variant<StagePacked, DomainFinished, TestFinished, StageFinished, ResultsKeptBeside,
                              StageTakenOver, StageFromResponses, Note, TaskBegun, TaskSkipped, TaskFailed>;

/// Callback functions for the run of a study or a sweep; each of them may be empty. An exception that they throw ends
/// the run.
struct RunObserver {
  ProgressObserver progress = {};
  std::function<void(const RunEvent&)> event = {};

  /// Passes an event on, if there is a function for it.
  void tell(const RunEvent& happened) const {
    if (event) event(happened);
  }
};

}  // namespace breccia

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

/// Results that replace earlier ones are written to this directory until they are complete.
struct ResultsKeptBeside {
  const std::filesystem::path& directory;
};

/// Another task of a sweep has computed this stage already; its files are in this directory.
struct StageTakenOver {
  const StageResult& stage;
  const std::filesystem::path& directory;
};

/// A stage was computed from the reduced responses of a task of the sweep at another temperature.
struct StageFromResponses {
  const StageResult& stage;
  const std::string& task;
};

/// Something that the user should know: a damaged file that is not used.
struct Note {
  std::string text;
};

/// A task of a sweep begins.
struct TaskBegun {
  const Sweep& sweep;
  std::size_t task;
};

/// A task of a sweep is complete already.
struct TaskSkipped {
  const Sweep& sweep;
  std::size_t task;
};

/// A task of a sweep has failed; the others still run.
struct TaskFailed {
  const Sweep& sweep;
  std::size_t task;
  std::string error;
};

/// What happens while a study or a sweep is run in a directory; what is found is written before it is told.
using RunEvent = std::variant<StagePacked, DomainFinished, TestFinished, ResultsKeptBeside, StageTakenOver,
                              StageFromResponses, Note, TaskBegun, TaskSkipped, TaskFailed>;

/// Functions that are called while a study or a sweep is run; each of them may be empty. An exception that they throw
/// ends the run.
struct RunObserver {
  ProgressObserver progress = {};
  std::function<void(const RunEvent&)> event = {};

  /// Passes an event on, if there is a function for it.
  void tell(const RunEvent& happened) const {
    if (event) event(happened);
  }
};

}  // namespace breccia

#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The relaxation modulus that one test of a stage has found in a task.
struct TaskCurve {
  std::string stage;
  TestId test;
  Curve modulus;

  /// Are both of the same test of the same stage?
  [[nodiscard]] bool matches(const TaskCurve& other) const { return stage == other.stage && test == other.test; }
};

enum class TaskState { waiting, done, failed };

template <>
inline constexpr auto words<TaskState> = std::to_array<Word<TaskState>>({{"waiting", TaskState::waiting},
                                                                         {"done", TaskState::done},
                                                                         {"failed", TaskState::failed}});

/// What became of a task of a sweep.
struct TaskResult {
  TaskState state = TaskState::waiting;
  std::vector<TaskCurve> curves = {};  ///< when it is done
  double seconds = 0.0;                ///< wall time of the run that has done it
  std::string error = {};              ///< why it has failed
};

/// In the order of the sweep's tasks.
using SweepResult = std::vector<TaskResult>;

/// The curves of a run.
std::vector<TaskCurve> curves_of(const StudyResult& result);

/// The curves that an earlier run has left in a directory. Throws FileError or InputError when they cannot be read.
std::vector<TaskCurve> read_curves(const std::filesystem::path& directory);

/// The names of the stages that the tasks have tested, in their order.
std::vector<std::string> tested_stages(const SweepResult& result);

/// The results with but one curve for each boundary of a stage: of shear if it was tested, and of the tests that differ
/// in method or grid the preferred one (is_preferred).
SweepResult stage_of(const SweepResult& result, const std::string& stage);

/// The same with the last stage of each task.
SweepResult last_stage_of(const SweepResult& result);

}  // namespace breccia

#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The relaxation modulus from one test of a stage in one task.
struct TaskCurve {
  std::string stage;
  TestId test;
  Curve modulus;
  /// The whole error at each time [-], nothing where it is not known; empty for a test that has no errors.
  std::vector<std::optional<double>> errors = {};
  /// The complex modulus at the frequencies of a study whose deck gives frequencies, rising, of the tests that
  /// dynamic.csv has; else empty.
  std::vector<ComplexSample> in_frequency = {};

  /// The whole error at the time nearest to the given one [s]; nothing where it is not known.
  [[nodiscard]] std::optional<double> error_at(double time) const;
  /// Whether both curves are of the same test of the same stage.
  [[nodiscard]] bool matches(const TaskCurve& other) const { return stage == other.stage && test == other.test; }
};

/// The state of a task of a sweep.
enum class TaskState { waiting, done, failed };

template <>
inline constexpr auto words<TaskState> = std::to_array<Word<TaskState>>({{"waiting", TaskState::waiting},
                                                                         {"done", TaskState::done},
                                                                         {"failed", TaskState::failed}});

/// The result of a task of a sweep.
struct TaskResult {
  TaskState state = TaskState::waiting;
  std::vector<TaskCurve> curves = {};  ///< curves of a finished task
  double seconds = 0.0;                ///< wall time of its run [s]
  std::string error = {};              ///< message of a failed task
};

/// One result for each task, in the order of the sweep.
using SweepResult = std::vector<TaskResult>;

/// The curves of a study.
std::vector<TaskCurve> curves_of(const StudyResult& result);

/// Reads the curves of an earlier run from its directory, without errors and complex moduli. Throws FileError or
/// InputError when they cannot be read.
std::vector<TaskCurve> read_curves(const std::filesystem::path& directory);

/// The same with the errors and, of a study in frequency, with the complex moduli.
std::vector<TaskCurve> read_task_curves(const std::filesystem::path& directory, Abscissa abscissa);

/// The names of the stages that the tasks have tested, in the order of the stages.
std::vector<std::string> tested_stages(const SweepResult& result);

/// The results reduced to one curve for each boundary of a stage: under shear if that was tested, and from the
/// preferred test (is_preferred) where tests differ in method or grid.
SweepResult stage_of(const SweepResult& result, const std::string& stage);

/// The results reduced to one curve for each boundary, as by stage_of(), of the last stage of each task.
SweepResult last_stage_of(const SweepResult& result);

}  // namespace breccia

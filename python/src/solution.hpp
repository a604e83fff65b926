#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "breccia/homogenisation/stage_responses.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

#include "box.hpp"
#include "results/composite.hpp"

namespace breccia::python {

/// The result of a stage, with its box as Python shows it.
struct SolvedStage {
  StageFindings result;
  std::optional<Box> box;  ///< of a response to another matrix nothing
};

/// What a calculation returns to Python: results, and what is needed to ask them for other materials.
struct Solution {
  StudyContent content;
  std::vector<SolvedStage> stages = {};
  std::optional<double> seconds = {};  ///< wall time [s]
  std::vector<StageResponses> responses = {};
};

/// The solution of a study from its result.
std::shared_ptr<Solution> solution_of(const Study& study, StudyResult result);

/// What a test of a stage is asked for by; nothing: whatever the stage has.
struct TestWords {
  std::optional<std::string> load, boundary, method, grid;
};

/// The preferred one (is_preferred) of the tests that these words fit. Throws InputError, with what was tested, where
/// none fits, or several boundaries do.
const TestResult& test_of(const StageFindings& stage, const TestWords& words);

}  // namespace breccia::python

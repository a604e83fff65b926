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
  std::optional<Box> box;  ///< content of the box; nothing for a response with other materials
};

/// The result of a calculation in Python: the results of the stages, and the data that a response with other materials
/// needs.
struct Solution {
  StudyContent content;
  std::vector<SolvedStage> stages = {};
  std::optional<double> seconds = {};  ///< wall time [s]
  std::vector<StageResponses> responses = {};
};

/// The solution of a study from its result.
std::shared_ptr<Solution> solution_of(const Study& study, StudyResult result);

/// The words by which a test of a stage is selected; a word that is absent fits any test.
struct TestWords {
  std::optional<std::string> load, boundary, method, grid;
};

/// The preferred one (is_preferred) of the tests that match these words. Throws InputError, with the tests that exist,
/// where no test matches, or tests under several boundaries do.
const TestResult& test_of(const StageFindings& stage, const TestWords& words);

/// As test_of(), of the tests that have fields: those of a grid under one load, not means of loads and of grids.
/// Without a load the first that has them. Throws InputError where no test has fields.
const TestResult& test_with_fields(const StageFindings& stage, const TestWords& words);

}  // namespace breccia::python

#pragma once

#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// The preferred test (is_preferred) for each load and boundary condition of a stage, in the order of the tests.
std::vector<const TestResult*> best_tests(const StageFindings& stage);

}  // namespace breccia

#pragma once

#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Of each load and boundary condition of a stage the preferred test (is_preferred), in the order of the tests.
std::vector<const TestResult*> best_tests(const StageFindings& stage);

}  // namespace breccia

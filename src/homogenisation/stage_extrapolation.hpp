#pragma once

#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// The limits of vanishing cells of all tests that were made on all grids of a stage.
/// Throws NumericalError where a limit is not positive.
std::vector<TestResult> extrapolate_tests(const Stage& stage, const std::vector<TestResult>& tests);

/// The relaxation modulus that a test of a stage found, at the times given where series that hold at all times tell
/// it (`tests` are all of the stage), else as it is.
Curve curve_at(const TestResult& test, const Stage& stage, const std::vector<TestResult>& tests,
               const std::vector<double>& times);

}  // namespace breccia

#pragma once

#include <vector>

#include "breccia/discretisation/mixture.hpp"
#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// The limits of vanishing cells of all tests that were run on all grids of a stage (theory, section 11): with points
/// they are extrapolated; with mixed cells they are the results on the finest grid, and the coarser grids tell their
/// error. Throws NumericalError if a limit is not positive.
std::vector<TestResult> extrapolate_tests(const Stage& stage, const std::vector<TestResult>& tests, Mixing mixing);

/// The relaxation modulus of a test of a stage at the given times [s], if it follows from exact series (`tests` are all
/// tests of the stage); otherwise the curve of the test.
Curve curve_at(const TestResult& test, const Stage& stage, const std::vector<TestResult>& tests, Mixing mixing,
               const std::vector<double>& times);

}  // namespace breccia

#pragma once

#include <string>
#include <vector>

#include "breccia/discretisation/mixture.hpp"
#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// The limits of vanishing cells of all tests of a stage that were run on several grids (theory, section 11): with
/// points they are extrapolated; with mixed cells they are the results on the finest grid, and the coarser grids give
/// their error. `side` is the side of the box [m], `mixing` that of the stage. Throws NumericalError, with the name of
/// the stage, if a limit is not positive.
std::vector<TestResult> extrapolate_tests(const std::string& stage, double side, int dimensions,
                                          const std::vector<TestResult>& tests, Mixing mixing);

/// The relaxation modulus of a test of a stage at the given times [s], if it follows from exact series (`tests` are all
/// tests of the stage); otherwise the curve of the test. `side` is the side of the box [m].
Curve curve_at(const TestResult& test, double side, int dimensions, const std::vector<TestResult>& tests, Mixing mixing,
               const std::vector<double>& times);

}  // namespace breccia

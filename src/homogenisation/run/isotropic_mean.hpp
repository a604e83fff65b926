#pragma once

#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// The tests whose mean has the load `isotropic`: the shears of a box of so many dimensions with the boundary, the
/// method and the grid of `beside`. Throws InputError where one of them is missing.
std::vector<const TestResult*> shears_beside(int dimensions, const TestId& beside,
                                             const std::vector<TestResult>& tests);

/// The mean of all shears of a box: of the relaxation moduli (theory, Eq. 13a) or, under tractions, of the creep
/// compliances (Eq. 13b). Throws as shears_beside(), and InputError where the curves have different times.
TestResult isotropic_mean(int dimensions, const TestId& beside, const std::vector<TestResult>& tests);

/// Whether a test is that of a shear in whose place tables and summaries have the mean of all shears of the box.
bool is_replaced_by_mean(const TestId& test, int dimensions, const std::vector<TestResult>& tests);

}  // namespace breccia

#pragma once

#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// The tests whose mean has the load `isotropic`: the shears of a box of so many dimensions with the boundary, the
/// method and the grid of `beside`. Throws InputError where one of them is missing.
std::vector<const TestResult*> shears_beside(int dimensions, const TestId& beside,
                                             const std::vector<TestResult>& tests);

/// The mean relaxation modulus of all shears of a box (theory, Eq. 13a), at the times of the first of them. Curves that
/// have other times are interpolated; beyond the ends of the others the mean has no samples. Of creep tests it has the
/// creep compliance that belongs to the mean modulus. Throws as shears_beside().
TestResult isotropic_mean(int dimensions, const TestId& beside, const std::vector<TestResult>& tests);

}  // namespace breccia

#pragma once

#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// The whole stiffness of a stage of so many dimensions, for each boundary under which it was solved for pairs of loads
/// (theory, Eqs. 13c and 13d). `tests` are the tests of the stage with their errors, `pairs` those under pairs of
/// loads.
std::vector<StageStiffness> whole_stiffness(int dimensions, const std::vector<TestResult>& tests,
                                            const std::vector<TestResult>& pairs);

}  // namespace breccia

#pragma once

#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// G(t) of a stage under all boundaries and by all methods beside each measurement of it, over the times that both
/// tell.
std::vector<Comparison> compare(const Study& study, const Stage& stage, const std::vector<TestResult>& tests);

}  // namespace breccia

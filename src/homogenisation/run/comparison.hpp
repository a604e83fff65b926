#pragma once

#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Compares G(t) of a stage, for all boundaries and methods, with each of its measurements, over the times of both.
std::vector<Comparison> compare(const Study& study, const Stage& stage, const std::vector<TestResult>& tests);

}  // namespace breccia

#pragma once

#include <vector>

#include "breccia/homogenisation/stage_responses.hpp"
#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Throws InputError if a stage builds on one that is not among them.
void require_earlier_stages(const std::vector<StageResponses>& stages);

/// The results of stages with the materials that they have, over a window of times [s], in the order in which they
/// build on each other. Throws NotCovered if one of the responses does not cover the whole window, InputError where a
/// stage lacks its matrix.
std::vector<StageResult> responded_stages(const std::vector<StageResponses>& stages, const TimeWindow& times);

}  // namespace breccia

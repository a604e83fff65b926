#pragma once

#include <vector>

#include "breccia/homogenisation/stage_responses.hpp"
#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Throws InputError if a stage builds on a stage that is not in the list.
void require_earlier_stages(const std::vector<StageResponses>& stages);

/// The results of stages with their present materials, over a window of times [s], in the order in which they build on
/// each other. Throws NotCovered if one of the responses does not cover the whole window, InputError where a stage
/// lacks its matrix.
std::vector<StageResult> responded_stages(const std::vector<StageResponses>& stages, const TimeWindow& times);

}  // namespace breccia

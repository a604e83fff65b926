#pragma once

#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Adds the thermal expansion of a stage to what was found of it, for each boundary and method, at the times of its
/// curves, from its tests in bulk and the materials that the `earlier` stages are. Nothing where the study asks for
/// none, and where it does not follow (obstacle_to_expansion); where a matrix that was computed is in the way, a
/// warning.
void add_expansions(const Study& study, const Stage& stage, const std::vector<StageResult>& earlier,
                    StageFindings& found);

}  // namespace breccia

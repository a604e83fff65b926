#pragma once

#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The thermal expansion of a stage for each boundary and method, at the times of its curves, from its tests in bulk
/// and the materials that earlier stages are. Nothing where the study asks for none, and where it does not follow
/// (obstacle_to_expansion). Throws InputError where the bulk moduli of filler and matrix cross (ThermalExpansion::add).
std::vector<StageExpansion> stage_expansions(const Study& study, const Stage& stage, const StageFindings& found,
                                             const std::vector<StageResult>& earlier);

/// Adds the thermal expansion to what was found of a stage or, where moduli cross, a warning that says so.
void add_expansions(const Study& study, const Stage& stage, const std::vector<StageResult>& earlier,
                    StageFindings& found);

}  // namespace breccia

#pragma once

#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The result of a stage as a material, for every boundary and method of the study: what later stages take as their
/// matrix. `earlier` are the stages that may have made its own. Throws NumericalError where a fit is worse than the
/// study tolerates.
std::vector<StageMaterial> materials_from(const Study& study, const Stage& stage,
                                          const std::vector<StageResult>& earlier, const StageResult& result);

/// The matrix of a stage under a boundary and by a method: a material, or what an earlier stage made of it.
const Material& matrix_of(const Stage& stage, const std::vector<StageResult>& earlier, Boundary boundary,
                          Method method);

}  // namespace breccia

#pragma once

#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The result of a stage as a material, for every boundary and method of the study; later stages use it as their
/// matrix. `earlier` are the results of the stages before it. Throws NumericalError if the error of a fit exceeds the
/// tolerance of the study, InputError if an earlier stage has no result for a boundary or a method.
std::vector<StageMaterial> materials_from(const Study& study, const Stage& stage,
                                          const std::vector<StageResult>& earlier, const StageResult& result);

/// The matrix of a stage under a boundary and by a method: a material, or the result of an earlier stage under the same
/// boundary and by the same method.
const Material& matrix_of(const Stage& stage, const std::vector<StageResult>& earlier, Boundary boundary,
                          Method method);

}  // namespace breccia

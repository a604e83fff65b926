#pragma once

#include <vector>

#include "breccia/discretisation/moduli.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Moduli [Pa] of the matrix of a stage over its whole relaxation, from stiff to soft. For a material they are its
/// relaxation_path(). For an earlier stage they are computed without a fit, by its reduced responses under the same
/// boundary along the path of its own matrix, as long as they fall and are positive (extrapolations from coarse grids
/// may not be). Empty if the earlier stage has no reduced responses.
std::vector<Moduli> matrix_moduli(const Study& study, const Stage& stage, const std::vector<StageResult>& earlier,
                                  Boundary boundary);

}  // namespace breccia

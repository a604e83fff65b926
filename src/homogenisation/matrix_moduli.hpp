#pragma once

#include <vector>

#include "breccia/discretisation/moduli.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Moduli [Pa] that the matrix of a stage shows over the whole of its relaxation, from stiff to soft: of a material its
/// relaxation_path(); of an earlier stage what its reduced responses under the same boundary make of its own matrix, as
/// far as that is a solid (the limit of coarse grids need not be), so that no fit comes between. Nothing where the
/// earlier stage has no reduced responses.
std::vector<Moduli> matrix_moduli(const Study& study, const Stage& stage, const std::vector<StageResult>& earlier,
                                  Boundary boundary);

}  // namespace breccia

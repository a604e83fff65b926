#pragma once

#include <vector>

#include "breccia/discretisation/moduli.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Moduli [Pa] of the phases of a stage that vary (varying_phases), in their order, over their whole relaxation, from
/// stiff to soft. With a material as the matrix they are the joint relaxation_path() of the phases. Where the matrix is
/// an earlier stage, its moduli are computed without a fit, by the reduced responses of that stage under the same
/// boundary along the path of its own phases, as long as they fall and are positive (extrapolations from coarse grids
/// may not be). Materials that the tests vary (Tests::varied) take each choice of choices_of_varied(): the paths of the
/// choices follow one another. Empty if the earlier stage has no reduced responses.
std::vector<std::vector<Moduli>> varying_moduli(const Study& study, const Stage& stage,
                                                const std::vector<StageResult>& earlier, Boundary boundary);

}  // namespace breccia

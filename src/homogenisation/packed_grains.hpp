#pragma once

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The grains of a stage: those of listed sites, or at random for the sizes of the filler. With them the result has the
/// size deviation of the filler. Throws InputError when the films leave nothing of any grain. Instantiated for 2 and 3
/// dimensions.
template <int dim>
Grains<dim> make_grains(const Stage& stage, const LaguerrePacking& method, StageMicrostructure& result);

}  // namespace breccia

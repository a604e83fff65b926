#pragma once

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Whether the films between grains are so narrow on the finest grid that flow through them serves: up to 1.4 cells.
/// Wider ones have errors of 8 to 11 % with flow, of 4 % in series (docs/gaps-under-a-cell.md).
[[nodiscard]] bool has_narrow_films(const Stage& stage, const Grains<2>& grains);

/// The mixing that the cells of a stage are expected to have: Mixing::flow is Mixing::series where a filler or a
/// coating is not stiffer than the matrix at all times, and between grains with wide films.
[[nodiscard]] Mixing mixing_of(const Study& study, const Stage& stage, const StageMicrostructure& packed);

}  // namespace breccia

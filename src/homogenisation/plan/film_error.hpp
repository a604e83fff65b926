#pragma once

#include <optional>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The error of the moduli of grains and thin films, by their elements and by what the model leaves out (theory,
/// Eq. 66b) [-]. Nothing where it was not measured: for films that are resolved or debonded or have shares, for
/// windows, coarser elements, thicker films or wider sizes, for grains that are not stiffer than the binder, and for a
/// stage that is computed with cells.
[[nodiscard]] std::optional<double> film_error(const Study& study, const Stage& stage,
                                               const StageMicrostructure& packed);

}  // namespace breccia

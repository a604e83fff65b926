#pragma once

#include <cstddef>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/microstructure/tessellation.hpp"

namespace breccia {

/// A tessellation of mixed cells (theory, Eq. 40) on `cells` cells along each axis: its grains, which a film of this
/// thickness [m] parts, are of one phase, and the film is of the matrix. The fractions of a cell are exact but for the
/// rounding to mixture_steps: they are the volumes that the planes of the grains leave of it. `phases` is the number of
/// phases, which the numbers of the mixtures follow. Throws InputError when a phase is beyond that number, or the film
/// has no thickness of 0 or more. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] Discretisation<dim> discretise_mixed(const Tessellation<dim>& tessellation, double film, int cells,
                                                   PhaseIndex matrix, PhaseIndex grains, std::size_t phases,
                                                   const CellLayers& layers = {});

}  // namespace breccia

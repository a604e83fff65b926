#pragma once

#include <cstddef>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/microstructure/tessellation.hpp"

namespace breccia {

/// A tessellation as mixed cells (theory, Eq. 40), `cells` along each axis: the grains have one phase, and the film of
/// this thickness [m] between them is matrix. The fractions of a cell are exact but for the rounding to mixture_steps:
/// they are the volumes of its intersections with the grains. The numbers of the mixtures follow those of the `phases`
/// phases. Throws InputError when a phase is beyond that number, or the thickness of the film is negative or not a
/// number. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] Discretisation<dim> discretise_mixed(const Tessellation<dim>& tessellation, double film, int cells,
                                                   PhaseIndex matrix, PhaseIndex grains, std::size_t phases,
                                                   const CellLayers& layers = {});

}  // namespace breccia

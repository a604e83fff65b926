#pragma once

#include "breccia/microstructure/cell_faces.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The debonded films of a stage of grains (Stage::bonds). Throws InputError that lists the pairs of grains without a
/// film between them.
template <int dim>
[[nodiscard]] CellFaces<dim> debonded_films(const Stage& stage, const Tessellation<dim>& tessellation);

}  // namespace breccia

#pragma once

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/discretisation.hpp"

#include "discretisation/gaps/gap_cells.hpp"

namespace breccia::gaps {

/// The gap cells of particles in a box, on `cells` cells along each axis, under a boundary; gaps are those between
/// coatings, and between coatings and sides under a displacement boundary. Throws InputError for particles that
/// overlap, and unless the boundary is periodic for a periodic box and for no other.
[[nodiscard]] GapCells<2> find_gap_cells(const ParticlesInBox<2>& particles, int cells, Boundary boundary);

}  // namespace breccia::gaps

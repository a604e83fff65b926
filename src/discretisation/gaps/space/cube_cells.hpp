#pragma once

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/discretisation.hpp"

#include "discretisation/gaps/gap_cells.hpp"

namespace breccia::gaps {

/// The gap cells of spheres in a periodic box, on `cells` cells along each axis; gaps are those between coatings.
/// Throws InputError for spheres that overlap or have no phases, a negative thickness of a coating, a box with walls,
/// and another boundary than a periodic one.
[[nodiscard]] GapCells<3> find_gap_cells(const ParticlesInBox<3>& particles, int cells, Boundary boundary);

}  // namespace breccia::gaps

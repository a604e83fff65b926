#pragma once

// The same for the cubic cells of 3 dimensions. Plain data only, too.

#include "cell_row_kernel.hpp"

namespace breccia::dynamics {

template <>
struct NodeValues<3> {
  const double* of_axis[3];  // NOLINT(modernize-avoid-c-arrays): plain data
};

/// Sums of those of all cells, row after row of the layer.
template <>
struct LayerForces<3> {
  double* of_axis[3];  // NOLINT(modernize-avoid-c-arrays): plain data
};

/// Bit 0 of the number of a row of nodes is its side along y, bit 1 that along z. Forces on the two rows on the lower
/// side along y are added to what is there, those on the other two are written: rows of cells are taken by rising y.
template <>
struct CellRow<3> {
  const Block* blocks;
  int block_count;
  NodeValues<3> displacement[4];  // NOLINT(modernize-avoid-c-arrays): plain data
  NodeValues<3> increment[4];     // NOLINT(modernize-avoid-c-arrays)
  LayerForces<3> force[4];        // NOLINT(modernize-avoid-c-arrays): forces [N] over the cell side
  double* stress;                 ///< sums in Voigt's order over the row's points, times the cell side
};

template <>
struct NodeRow<3> {
  int count;                     ///< a multiple of the lanes
  double* displacement[3];       // NOLINT(modernize-avoid-c-arrays): plain data
  double* increment[3];          // NOLINT(modernize-avoid-c-arrays)
  const double* step_over_mass;  ///< dt^2 h / m [m^2/N], zero where the motion is prescribed
  LayerForces<3> from_cells_below;
  LayerForces<3> from_cells_above;
};

}  // namespace breccia::dynamics

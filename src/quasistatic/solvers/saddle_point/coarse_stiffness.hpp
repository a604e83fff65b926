#pragma once

#include "quasistatic/operator/cell_sweep.hpp"
#include "quasistatic/operator/matrix_entries.hpp"
#include "quasistatic/solvers/lattice/nodal_field.hpp"
#include "quasistatic/solvers/saddle_point/rigid_aggregates.hpp"

namespace breccia::quasistatic {

/// The stiffness matrix [Pa] of a periodic box for the rigid motions of its aggregates, by the entries of its upper
/// triangle. It resists translations of the box a little, so that it is positive definite.
[[nodiscard]] MatrixEntries coarse_stiffness(const NodeLattice& lattice, const CellModuli& cells,
                                             const RigidAggregates& aggregates);

}  // namespace breccia::quasistatic

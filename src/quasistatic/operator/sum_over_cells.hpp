#pragma once

#include <utility>

#include "quasistatic/operator/node_layout.hpp"
#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {

/// Forces of all cells on the nodes, and their work on the macroscopic part.
struct SumOverCells {
  double macroscopic;
  NodalVector on_nodes;
};

/// Sums the results of cell_forces(cell) over all cells: the forces on the nodes and their work on the macroscopic
/// part.
template <int dim, class CellForces>
[[nodiscard]] SumOverCells sum_over_cells(const NodeLayout<dim>& nodes, const CellForces& cell_forces) {
  const auto local = nodes.local_zeros();
  double macroscopic = 0.0;
  {
    const WriteValues values(local.get());
    nodes.for_cells([&](const Index<dim>& cell) {
      const auto forces = cell_forces(cell);
      macroscopic += forces.second;
      nodes.add_to_cell(cell, forces.first, values.data());
    });
  }
  auto on_nodes = nodes.zeros();
  nodes.sum_up(local.get(), on_nodes.get());
  MPI_Allreduce(MPI_IN_PLACE, &macroscopic, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return {macroscopic, std::move(on_nodes)};
}

}  // namespace breccia::quasistatic

#pragma once

#include "dynamics/dynamic_problem.hpp"
#include "dynamics/dynamic_solver.hpp"
#include "dynamics/nodal_field.hpp"

namespace breccia::dynamics {

/// The nodes of a run that belong to this process, those of some layers: each node belongs to exactly one process.
template <int dim>
struct OwnNodes {
  const DynamicProblem<dim>* problem;
  const NodalField<dim>* field;
  int first_layer, end_layer;
};

// Sums over the nodes of all processes; the units are those of DynamicSolver. Instantiated for 2 and 3 dimensions.

template <int dim>
[[nodiscard]] Vector<dim> momentum_of(const OwnNodes<dim>& nodes);

/// The kinetic energy of the nodes and the strain energy of the cells, of elastic materials.
template <int dim>
[[nodiscard]] Energy energy_of(const OwnNodes<dim>& nodes);

/// The position where the displacement of a step is largest or not a number [m].
template <int dim>
[[nodiscard]] Vector<dim> most_moved_of(const OwnNodes<dim>& nodes);

}  // namespace breccia::dynamics

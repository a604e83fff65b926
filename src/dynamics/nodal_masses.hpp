#pragma once

#include <vector>

#include "breccia/dynamics/dynamic_problem.hpp"

namespace breccia::dynamics {

/// Lumped masses of the nodes [kg], in 2D per unit thickness [kg/m], times the mass scaling factor:
/// m_I = sum_p w_Ip m_p, in the order of Grid::node_index. Nodes of a periodic box that are one have the mass of all of
/// them. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] std::vector<double> nodal_masses(const DynamicProblem<dim>& problem);

}  // namespace breccia::dynamics

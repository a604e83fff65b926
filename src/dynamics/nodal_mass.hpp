#pragma once

#include "dynamics/dynamic_problem.hpp"

namespace breccia::dynamics {

/// Lumped mass of a node [kg], in 2D per unit thickness [kg/m], times the mass scaling factor: m_I = sum_p w_Ip m_p. A
/// node of a periodic box and its images have the mass of all of them. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] double nodal_mass(const DynamicProblem<dim>& problem, const Index<dim>& node);

}  // namespace breccia::dynamics

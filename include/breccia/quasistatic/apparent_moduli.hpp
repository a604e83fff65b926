#pragma once

#include <span>
#include <vector>

#include "breccia/discretisation/load.hpp"
#include "breccia/quasistatic/quasistatic_problem.hpp"

namespace breccia {

/// The apparent moduli [Pa] of an elastic composite: mean stress over mean strain of the box under each of the loads,
/// with the boundary condition of the problem. Throws InputError when there are no loads, a point has no
/// material or a material relaxes, NumericalError when a linear system cannot be solved. Instantiated for 2 and 3
/// dimensions.
template <int dim>
std::vector<double> apparent_moduli(const QuasistaticProblem<dim>& problem, std::span<const Load> loads);

}  // namespace breccia

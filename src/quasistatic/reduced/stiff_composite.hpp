#pragma once

#include <span>

#include "breccia/quasistatic/quasistatic_problem.hpp"

namespace breccia {

/// Throws InputError where voids leave a composite without stiffness under one of the loads, by its unrelaxed moduli.
/// Does nothing for a composite without voids. For methods that would go on with such a composite; those that sample
/// elastic solutions find it themselves. Instantiated for 2 and 3 dimensions.
template <int dim>
void require_stiff(QuasistaticProblem<dim> problem, std::span<const Load> loads);

}  // namespace breccia

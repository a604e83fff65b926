#pragma once

#include "breccia/discretisation/point_fields.hpp"

#include "dynamics/block_layout.hpp"
#include "dynamics/dynamic_problem.hpp"
#include "dynamics/nodal_field.hpp"

namespace breccia::dynamics {

/// Displacement, strain and stress in the cells of this process: at the material points of square cells, or means over
/// cubic cells. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] LatticeFields<dim> recover_fields(const DynamicProblem<dim>& problem, const NodalField<dim>& nodes,
                                                const BlockLayout<dim>& layout);

}  // namespace breccia::dynamics

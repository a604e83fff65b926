#pragma once

#include "breccia/discretisation/point_fields.hpp"

#include "dynamics/block_layout.hpp"
#include "dynamics/dynamic_problem.hpp"
#include "dynamics/nodal_field.hpp"

namespace breccia::dynamics {

/// Displacement, strain and stress of the material points of a square, or their means over the cells of a cube, of the
/// cells of this process. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] LatticeFields<dim> recover_fields(const DynamicProblem<dim>& problem, const NodalField<dim>& nodes,
                                                const BlockLayout<dim>& layout);

}  // namespace breccia::dynamics

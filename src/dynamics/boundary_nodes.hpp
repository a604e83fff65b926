#pragma once

#include "breccia/dynamics/dynamic_problem.hpp"

namespace breccia::dynamics {

// Instantiated for 2 and 3 dimensions.

/// True if the node follows the affine motion of the load, whatever the forces on it.
template <int dim>
[[nodiscard]] bool is_prescribed(const DynamicProblem<dim>& problem, const Index<dim>& node) noexcept;

/// True if the node, on the upper side of a periodic box along some axis, stands for the node on the opposite side.
template <int dim>
[[nodiscard]] bool is_image(const DynamicProblem<dim>& problem, const Index<dim>& node) noexcept;

/// True if, while the load rises, nodes that are not prescribed get the acceleration of its affine motion.
template <int dim>
[[nodiscard]] bool follows_affinely(const DynamicProblem<dim>& problem) noexcept;

/// Displacement of a node in the affine motion of the whole load [m]. Under a displacement boundary the centre of the
/// box rests, so that the boundary strains the box and does not shake it; else the lowest corner rests.
template <int dim>
[[nodiscard]] Vector<dim> affine_motion(const DynamicProblem<dim>& problem, const Index<dim>& node) noexcept;

/// Difference of the affine displacements of two places that are `cells` cell sides apart [m].
template <int dim>
[[nodiscard]] Vector<dim> affine_difference(const DynamicProblem<dim>& problem, const Vector<dim>& cells) noexcept;

/// Integral of the node's shape function times the outward normal over the boundary of the box [m^(dim-1)]; zero
/// inside.
template <int dim>
[[nodiscard]] Vector<dim> outward_area(const Grid<dim>& grid, const Index<dim>& node) noexcept;

/// Consistent nodal force of the whole traction [N], in 2D per unit thickness [N/m].
template <int dim>
[[nodiscard]] Vector<dim> traction_force(const DynamicProblem<dim>& problem, const Index<dim>& node) noexcept;

/// Throws InputError when a traction would act on a node without mass.
template <int dim>
void require_points_under_traction(const DynamicProblem<dim>& problem);

/// Calls action(column) for the nodes of a row that lie on the boundary of the box.
template <class Action>
void for_boundary_nodes(const Grid<2>& grid, int row, Action&& action) {
  const int stride = row == 0 || row == grid.rows() ? 1 : grid.columns();
  for (int column = 0; column <= grid.columns(); column += stride) action(column);
}

}  // namespace breccia::dynamics

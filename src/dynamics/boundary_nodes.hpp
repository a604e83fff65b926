#pragma once

#include <cstddef>

#include "dynamics/dynamic_problem.hpp"

namespace breccia::dynamics {

// Instantiated for 2 and 3 dimensions.

/// Whether the node follows the affine motion of the load, whatever the forces on it are.
template <int dim>
[[nodiscard]] bool is_prescribed(const DynamicProblem<dim>& problem, const Index<dim>& node) noexcept;

/// Whether the node is the image of a node on the opposite side: whether it is on the upper side of a periodic box
/// along some axis.
template <int dim>
[[nodiscard]] bool is_image(const DynamicProblem<dim>& problem, const Index<dim>& node) noexcept;

/// Whether nodes that are not prescribed get the acceleration of the affine motion of the load while the load rises.
template <int dim>
[[nodiscard]] bool follows_affinely(const DynamicProblem<dim>& problem) noexcept;

/// Displacement of a node in the affine motion of the whole load [m]. Under a displacement boundary the centre of the
/// box rests, so that the boundary strains the box and does not shake it; otherwise the lowest corner rests.
template <int dim>
[[nodiscard]] Vector<dim> affine_motion(const DynamicProblem<dim>& problem, const Index<dim>& node) noexcept;

/// Difference of the affine displacements of two positions that are `cells` cell sides apart [m].
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

/// Calls action(node) for the nodes of a layer, a row along x in 2 dimensions and a plane across z in 3.
template <int dim, class Action>
void for_nodes_of_layer(const Grid<dim>& grid, int layer, Action&& action) {
  Index<dim> begin{};
  auto end = grid.nodes();
  begin.back() = layer;
  end.back() = layer + 1;
  for_each_index(begin, end, action);
}

/// Calls action(node) for the nodes of a layer that lie on the boundary of the box.
template <int dim, class Action>
void for_boundary_nodes(const Grid<dim>& grid, int layer, Action&& action) {
  const auto is_on_side = [&grid](const Index<dim>& node) {
    for (std::size_t axis = 1; axis < node.size(); ++axis) {
      if (node[axis] == 0 || node[axis] == grid.cells[axis]) return true;
    }
    return false;
  };
  Index<dim> begin{};
  auto end = grid.nodes();
  begin.back() = layer;
  end.back() = layer + 1;
  end[0] = 1;
  for_each_index(begin, end, [&](Index<dim> node) {
    const int stride = is_on_side(node) ? 1 : grid.cells[0];
    for (node[0] = 0; node[0] <= grid.cells[0]; node[0] += stride) action(node);
  });
}

}  // namespace breccia::dynamics

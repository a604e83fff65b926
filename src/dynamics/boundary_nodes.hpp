#pragma once

#include "breccia/dynamics/dynamic_problem.hpp"

namespace breccia::dynamics {

/// The node follows the affine motion of the load, whatever the forces on it.
bool is_prescribed(const DynamicProblem& problem, int column, int row) noexcept;

/// The node, on the right or upper side of a periodic box, stands for the one on the opposite side.
bool is_image(const DynamicProblem& problem, int column, int row) noexcept;

/// While the load rises, nodes that are not prescribed get the acceleration of its affine motion.
bool follows_affinely(const DynamicProblem& problem) noexcept;

/// Displacement of a node in the affine motion of the whole load [m]. Under a displacement boundary the centre of the
/// box rests, so that the boundary strains the box and does not shake it; else the lower left corner does.
Vector<2> affine_motion(const DynamicProblem& problem, int column, int row) noexcept;

/// The difference of that between two places so many columns and rows apart [m].
Vector<2> affine_difference(const DynamicProblem& problem, double columns, double rows) noexcept;

/// Integral of the node's shape function times the outward normal over the boundary of the box [m]; zero inside.
Vector<2> outward_side(const Grid& grid, int column, int row) noexcept;

/// Consistent nodal force of the traction of the whole load, per unit thickness [N/m].
Vector<2> traction_force(const DynamicProblem& problem, int column, int row) noexcept;

/// Calls action(column) for the nodes of a row that lie on the boundary of the box.
template <class Action>
void for_boundary_nodes(const Grid& grid, int row, Action&& action) {
  const int stride = row == 0 || row == grid.rows ? 1 : grid.columns;
  for (int column = 0; column <= grid.columns; column += stride) action(column);
}

/// Throws InputError when the traction of a load would act on a node without mass.
void require_points_under_traction(const DynamicProblem& problem);

}  // namespace breccia::dynamics

#include "dynamics/boundary_nodes.hpp"

#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "dynamics/nodal_mass.hpp"

namespace breccia::dynamics {
namespace {

template <int dim>
bool is_on_upper_side(const Grid<dim>& grid, const Index<dim>& node) noexcept {
  for (std::size_t axis = 0; axis < node.size(); ++axis) {
    if (node[axis] == grid.cells[axis]) return true;
  }
  return false;
}

template <int dim>
bool is_on_boundary(const Grid<dim>& grid, const Index<dim>& node) noexcept {
  for (const int index : node) {
    if (index == 0) return true;
  }
  return is_on_upper_side(grid, node);
}

}  // namespace

template <int dim>
bool is_prescribed(const DynamicProblem<dim>& problem, const Index<dim>& node) noexcept {
  return problem.boundary == Boundary::displacement && is_on_boundary(problem.discretisation.grid(), node);
}

template <int dim>
bool is_image(const DynamicProblem<dim>& problem, const Index<dim>& node) noexcept {
  return problem.boundary == Boundary::periodic && is_on_upper_side(problem.discretisation.grid(), node);
}

template <int dim>
bool follows_affinely(const DynamicProblem<dim>& problem) noexcept {
  switch (problem.boundary) {
    case Boundary::displacement:
      return problem.start == Start::affine;
    case Boundary::traction:
      return false;
    case Boundary::periodic:
      return true;
  }
  return false;
}

template <int dim>
Vector<dim> affine_motion(const DynamicProblem<dim>& problem, const Index<dim>& node) noexcept {
  const auto& cells = problem.discretisation.grid().cells;
  const double at_rest = problem.boundary == Boundary::displacement ? 0.5 : 0.0;
  Vector<dim> from_rest{};
  for (std::size_t axis = 0; axis < node.size(); ++axis) from_rest[axis] = node[axis] - at_rest * cells[axis];
  return affine_difference(problem, from_rest);
}

template <int dim>
Vector<dim> affine_difference(const DynamicProblem<dim>& problem, const Vector<dim>& cells) noexcept {
  auto x = cells;
  for (double& along : x) along *= problem.discretisation.grid().cell_side;
  return product(problem.load, x);
}

template <int dim>
Vector<dim> outward_area(const Grid<dim>& grid, const Index<dim>& node) noexcept {
  Vector<dim> area{};
  for (std::size_t axis = 0; axis < node.size(); ++axis) {
    area[axis] = node[axis] == 0 ? -1.0 : node[axis] == grid.cells[axis] ? 1.0 : 0.0;
    for (std::size_t other = 0; other < node.size(); ++other) {
      if (other == axis) continue;
      const bool at_end = node[other] == 0 || node[other] == grid.cells[other];
      area[axis] *= grid.cell_side * (at_end ? 0.5 : 1.0);
    }
  }
  return area;
}

template <int dim>
Vector<dim> traction_force(const DynamicProblem<dim>& problem, const Index<dim>& node) noexcept {
  return product(problem.traction, outward_area(problem.discretisation.grid(), node));
}

template <int dim>
void require_points_under_traction(const DynamicProblem<dim>& problem) {
  if (problem.boundary != Boundary::traction || problem.traction == Stress<dim>{}) return;
  const auto& grid = problem.discretisation.grid();
  const auto require_mass = [&](const Index<dim>& node) {
    if (nodal_mass(problem, node) > 0.0) return;
    Vector<dim> position{};
    for (std::size_t axis = 0; axis < node.size(); ++axis) position[axis] = node[axis] * grid.cell_side;
    throw InputError(fmt::format("dynamic run: a traction acts at ({:.4g}) m, where the box has no points",
                                 fmt::join(position, ", ")));
  };
  for (int layer = 0; layer <= grid.cells.back(); ++layer) for_boundary_nodes(grid, layer, require_mass);
}

#define BRECCIA_INSTANTIATE(dim)                                                                   \
  template bool is_prescribed(const DynamicProblem<dim>&, const Index<dim>&) noexcept;             \
  template bool is_image(const DynamicProblem<dim>&, const Index<dim>&) noexcept;                  \
  template bool follows_affinely(const DynamicProblem<dim>&) noexcept;                             \
  template Vector<dim> affine_motion(const DynamicProblem<dim>&, const Index<dim>&) noexcept;      \
  template Vector<dim> affine_difference(const DynamicProblem<dim>&, const Vector<dim>&) noexcept; \
  template Vector<dim> outward_area(const Grid<dim>&, const Index<dim>&) noexcept;                 \
  template Vector<dim> traction_force(const DynamicProblem<dim>&, const Index<dim>&) noexcept;     \
  template void require_points_under_traction(const DynamicProblem<dim>&);
BRECCIA_INSTANTIATE(2)
BRECCIA_INSTANTIATE(3)
#undef BRECCIA_INSTANTIATE

}  // namespace breccia::dynamics

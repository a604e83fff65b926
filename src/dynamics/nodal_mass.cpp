#include "dynamics/nodal_mass.hpp"

#include <array>
#include <cstddef>

#include "discretisation/cell_shape.hpp"

namespace breccia::dynamics {
namespace {

/// The weights of the nodes at all points of a cell.
template <int dim>
const auto& all_weights() {
  using Shape = CellShape<dim>;
  static const auto weights = [] {
    std::array<typename Shape::Weights, std::size_t{Shape::points}> all{};
    for (int p = 0; p < Shape::points; ++p) all[static_cast<std::size_t>(p)] = Shape::weights(p);
    return all;
  }();
  return weights;
}

/// Mass that a node has from the cells around it in the box.
template <int dim>
double mass_of_cells_around(const DynamicProblem<dim>& problem, const Index<dim>& node) {
  using Shape = CellShape<dim>;
  const auto& grid = problem.discretisation.grid();
  const double point_volume = times_power<dim>(Shape::point_volume, grid.cell_side);
  const auto& weights = all_weights<dim>();
  double sum = 0.0;
  // The node is the last corner of the first of the cells around it, and the first corner of the last one.
  for (std::size_t corner = Shape::nodes; corner-- > 0;) {
    auto cell = node;
    for (std::size_t axis = 0; axis < cell.size(); ++axis) {
      cell[axis] -= Shape::corner(static_cast<int>(corner))[axis];
    }
    if (!grid.all_cells().contains(cell)) continue;
    const auto& phases = problem.discretisation.cell(cell);
    for (std::size_t p = 0; p < phases.size(); ++p) {
      if (phases[p] == no_phase) continue;
      const double mass = problem.mass_scaling * problem.materials[phases[p]].density * point_volume;
      sum += weights[p][corner] * mass;
    }
  }
  return sum;
}

/// Mass of a node, together with the periodic images of it along the axes before `axes`.
template <int dim>
double joined_mass(const DynamicProblem<dim>& problem, Index<dim> node, std::size_t axes) {
  if (axes == 0) return mass_of_cells_around(problem, node);
  const auto axis = axes - 1;
  const int last = problem.discretisation.grid().cells[axis];
  if (node[axis] != 0 && node[axis] != last) return joined_mass(problem, node, axis);
  auto image = node;
  node[axis] = 0;
  image[axis] = last;
  return joined_mass(problem, image, axis) + joined_mass(problem, node, axis);
}

}  // namespace

template <int dim>
double nodal_mass(const DynamicProblem<dim>& problem, const Index<dim>& node) {
  constexpr std::size_t all_axes = dim, none = 0;
  return joined_mass(problem, node, problem.boundary == Boundary::periodic ? all_axes : none);
}

template double nodal_mass(const DynamicProblem<2>&, const Index<2>&);
template double nodal_mass(const DynamicProblem<3>&, const Index<3>&);

}  // namespace breccia::dynamics

#include "dynamics/layer_step.hpp"

#include <algorithm>
#include <cstddef>

#include "dynamics/boundary_nodes.hpp"
#include "dynamics/kernels.hpp"
#include "dynamics/step_times.hpp"

namespace breccia::dynamics {
namespace {

/// Layers of nodes below and above the layers of cells [first_layer, end_layer). Where the highest of them is the image
/// of the lowest layer of the box, that lowest layer as well.
template <int dim>
HeldLayers held_layers(const DynamicProblem<dim>& problem, int first_layer, int end_layer) {
  const bool has_image =
      problem.boundary == Boundary::periodic && end_layer == problem.discretisation.grid().cells.back();
  return {.first = first_layer, .end = end_layer + 1, .lowest = has_image && first_layer > 0 ? 1 : 0};
}

}  // namespace

template <int dim>
LayerStep<dim>::LayerStep(const DynamicProblem<dim>& problem, InstructionSet instructions, int first_layer,
                          int end_layer)
    : problem_(&problem),
      kernels_(&kernels<dim>(instructions)),
      layout_(problem, first_layer, end_layer),
      nodes_(problem.discretisation.grid(), held_layers(problem, first_layer, end_layer)) {}

template <int dim>
void LayerStep<dim>::find_row_forces(const CellRow<dim>& row) const {
  if (problem_->volumetric == Volumetric::averaged) {
    kernels_->cell_row_averaged(row);
  } else {
    kernels_->cell_row_standard(row);
  }
}

template <int dim>
void LayerStep<dim>::find_cell_forces(int layer, const LayerForces<dim>& below, const LayerForces<dim>& above,
                                      Sums& sums) {
  // The first row of cells of a plane adds its forces to these.
  if constexpr (adds_to_row<dim>(0)) {
    for (const auto& forces : {below, above}) {
      for (double* along : forces.of_axis) std::fill_n(along, nodes_.stride(), 0.0);
    }
  }
  sums.stress = {};
  for (int row = 0; row < layout_.rows_of_layer(); ++row) {
    std::array<double, static_cast<std::size_t>(tensor_components<dim>)> stress{};
    CellRow<dim> cells = {.blocks = layout_.row(layer, row),
                          .block_count = layout_.blocks_per_row(),
                          .displacement = {},
                          .increment = {},
                          .force = {},
                          .stress = stress.data()};
    constexpr int rows_of_side = rows_of_nodes<dim> / 2;  // number of rows of nodes below the cells, and above them
    for (int i = 0; i < rows_of_nodes<dim>; ++i) {
      const int row_of_nodes = row + i % rows_of_side, layers_up = i / rows_of_side;
      const int of_nodes = nodes_.row_of(layer + layers_up, row_of_nodes);
      const auto u = nodes_.displacement(of_nodes), du = nodes_.increment(of_nodes);
      cells.force[i] = nodes_.along_row(layers_up == 0 ? below : above, row_of_nodes);
      for (std::size_t c = 0; c < u.size(); ++c) {
        cells.displacement[i].of_axis[c] = u[c];
        cells.increment[i].of_axis[c] = du[c];
      }
    }
    find_row_forces(cells);
    for (std::size_t i = 0; i < stress.size(); ++i) sums.stress[i] += stress[i];
  }
}

/// Gives the nodes on the lower sides of a layer the forces of the cells on the upper sides. The nodes on the upper
/// sides are images.
template <int dim>
void LayerStep<dim>::join_sides(const LayerForces<dim>& forces) const {
  const auto& cells = problem_->discretisation.grid().cells;
  const auto stride = nodes_.stride();
  for (double* along : forces.of_axis) {
    if constexpr (dim == 3) {
      const double* last_row = along + stride * static_cast<std::size_t>(cells[1]);
      for (int column = 0; column <= cells[0]; ++column) along[column] += last_row[column];
    }
    for (int row = 0; row < layout_.rows_of_layer(); ++row, along += stride) along[0] += along[cells[0]];
  }
}

template <int dim>
void LayerStep<dim>::find_forces(int layer, const LayerForces<dim>& below, const LayerForces<dim>& above,
                                 LayerSums<dim>& sums, int index) {
  find_cell_forces(layer, below, above, sums.of(layer, index));
  switch (problem_->boundary) {
    case Boundary::displacement:
      break;
    case Boundary::traction:
      sums.of(layer, index).strain = boundary_strain(layer);
      if (layer + 1 == problem_->discretisation.grid().cells.back()) {
        sums.of(layer + 1, index).strain = boundary_strain(layer + 1);
      }
      break;
    case Boundary::periodic:
      join_sides(below);
      join_sides(above);
      break;
  }
}

template <int dim>
void LayerStep<dim>::integrate(int layer, const LayerForces<dim>& from_cells_below,
                               const LayerForces<dim>& from_cells_above) {
  for (int row_of_nodes = 0; row_of_nodes < nodes_.rows_of_layer(); ++row_of_nodes) {
    const int number = nodes_.row_of(layer, row_of_nodes);
    const auto u = nodes_.displacement(number), du = nodes_.increment(number);
    NodeRow<dim> row = {.count = (layout_.blocks_per_row() + 1) * lanes,
                        .displacement = {},
                        .increment = {},
                        .step_over_mass = nodes_.step_over_mass(number),
                        .from_cells_below = nodes_.along_row(from_cells_below, row_of_nodes),
                        .from_cells_above = nodes_.along_row(from_cells_above, row_of_nodes)};
    for (std::size_t c = 0; c < u.size(); ++c) {
      row.displacement[c] = u[c];
      row.increment[c] = du[c];
    }
    kernels_->node_row(row);
  }
}

template <int dim>
void LayerStep<dim>::move_nodes(int layer, const LayerForces<dim>& from_cells_below,
                                const LayerForces<dim>& from_cells_above, std::int64_t step) {
  integrate(layer, from_cells_below, from_cells_above);
  const bool load_rises = load_at(*problem_, step - 1) < 1.0;
  switch (problem_->boundary) {
    case Boundary::displacement:
      if (load_rises) follow_load(layer, step);
      break;
    case Boundary::traction:
      add_traction(layer, step);
      break;
    case Boundary::periodic:
      if (load_rises) follow_load(layer, step);
      close_layer(layer, step);
      break;
  }
}

template <int dim>
void LayerStep<dim>::follow_load(int layer, std::int64_t step) {
  const auto& grid = problem_->discretisation.grid();
  const double now = load_at(*problem_, step);
  const double next = load_at(*problem_, step + 1);
  if (follows_affinely(*problem_)) {
    const double acceleration = next - 2.0 * now + load_at(*problem_, step - 1);
    for_nodes_of_layer(grid, layer, [&](const Index<dim>& node) {
      const auto affine = affine_motion(*problem_, node);
      const int row = nodes_.row_of(node), column = node[0];
      const auto u = nodes_.displacement(row), du = nodes_.increment(row);
      for (std::size_t i = 0; i < affine.size(); ++i) {
        u[i][column] += acceleration * affine[i];
        du[i][column] += acceleration * affine[i];
      }
    });
  }
  if (problem_->boundary != Boundary::displacement) return;
  for_boundary_nodes(grid, layer, [&](const Index<dim>& node) {
    const auto affine = affine_motion(*problem_, node);
    const int row = nodes_.row_of(node), column = node[0];
    const auto u = nodes_.displacement(row), du = nodes_.increment(row);
    for (std::size_t i = 0; i < affine.size(); ++i) {
      u[i][column] = next * affine[i];
      du[i][column] = (next - now) * affine[i];
    }
  });
}

template <int dim>
void LayerStep<dim>::add_traction(int layer, std::int64_t step) {
  const double now = load_at(*problem_, step) / side_power();
  for_boundary_nodes(problem_->discretisation.grid(), layer, [&](const Index<dim>& node) {
    const auto force = traction_force(*problem_, node);
    const int row = nodes_.row_of(node), column = node[0];
    const auto u = nodes_.displacement(row), du = nodes_.increment(row);
    const double scale = now * nodes_.step_over_mass(row)[column];
    for (std::size_t i = 0; i < force.size(); ++i) {
      u[i][column] += scale * force[i];
      du[i][column] += scale * force[i];
    }
  });
}

/// The power of the cell side h^(dim - 2) [m^(dim - 2)] by which the nodal forces of the kernel are divided.
template <int dim>
double LayerStep<dim>::side_power() const {
  return times_power<dim - 2>(1.0, problem_->discretisation.grid().cell_side);
}

/// Makes neighbouring nodes of a row the images of others.
template <int dim>
void LayerStep<dim>::copy_image(const Index<dim>& from, const Index<dim>& to, int nodes, std::int64_t step) {
  Vector<dim> cells{};
  for (std::size_t axis = 0; axis < cells.size(); ++axis) cells[axis] = to[axis] - from[axis];
  const auto across = affine_difference(*problem_, cells);
  const double next = load_at(*problem_, step + 1), rise = next - load_at(*problem_, step);
  const int from_row = nodes_.row_of(from), to_row = nodes_.row_of(to);
  const auto from_u = nodes_.displacement(from_row), from_du = nodes_.increment(from_row);
  const auto u = nodes_.displacement(to_row), du = nodes_.increment(to_row);
  for (std::size_t i = 0; i < across.size(); ++i) {
    for (int node = 0; node < nodes; ++node) {
      u[i][to[0] + node] = from_u[i][from[0] + node] + next * across[i];
      du[i][to[0] + node] = from_du[i][from[0] + node] + rise * across[i];
    }
  }
}

/// Makes the last nodes of a layer along x, and in 3 dimensions along y, the images of the first.
template <int dim>
void LayerStep<dim>::close_layer(int layer, std::int64_t step) {
  const auto& cells = problem_->discretisation.grid().cells;
  Index<dim> first{};
  first.back() = layer;
  for (int row = 0; row < nodes_.rows_of_layer(); ++row) {
    if constexpr (dim == 3) first[1] = row;
    auto last = first;
    last[0] = cells[0];
    copy_image(first, last, 1, step);
  }
  if constexpr (dim == 3) copy_image({0, 0, layer}, {0, cells[1], layer}, cells[0] + 1, step);
}

template <int dim>
void LayerStep<dim>::copy_lowest_layer(std::int64_t step) {
  const auto& cells = problem_->discretisation.grid().cells;
  for (int row = 0; row < nodes_.rows_of_layer(); ++row) {
    Index<dim> from{};
    if constexpr (dim == 3) from[1] = row;
    auto to = from;
    to.back() = cells.back();
    copy_image(from, to, cells[0] + 1, step);
  }
}

template <int dim>
Strain<dim> LayerStep<dim>::boundary_strain(int layer) const {
  const auto& grid = problem_->discretisation.grid();
  Strain<dim> sum;
  for_boundary_nodes(grid, layer, [&](const Index<dim>& node) {
    const auto area = outward_area<dim>(grid, node);
    const auto u = nodes_.displacement(nodes_.row_of(node));
    const int column = node[0];
    for (int i = 0; i < dim; ++i) {
      const auto a = static_cast<std::size_t>(i);
      component(sum, i) += u[a][column] * area[a];
      for (int j = 0; j < i; ++j) {
        const auto b = static_cast<std::size_t>(j);
        component(sum, component_index<dim>(i, j)) += 0.5 * (u[b][column] * area[a] + u[a][column] * area[b]);
      }
    }
  });
  return sum;
}

template class LayerStep<2>;
template class LayerStep<3>;

}  // namespace breccia::dynamics

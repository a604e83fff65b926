#include "quasistatic/operator/node_layout.hpp"

#include <algorithm>

#include <petscdmda.h>

#include "quasistatic/operator/block_division.hpp"
#include "quasistatic/operator/natural_order.hpp"
#include "quasistatic/operator/of_nodes.hpp"
#include "quasistatic/operator/plane_division.hpp"
#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

/// Number of a cell or node in a box, the first axis fastest.
template <int dim>
int number_in(const Index<dim>& index, const Index<dim>& begin, const Index<dim>& end) noexcept {
  int number = 0;
  for (std::size_t axis = index.size(); axis-- > 0;) {
    number = number * (end[axis] - begin[axis]) + index[axis] - begin[axis];
  }
  return number;
}

template <int dim>
Index<dim> sum(Index<dim> index, const Index<dim>& other) noexcept {
  for (std::size_t axis = 0; axis < index.size(); ++axis) index[axis] += other[axis];
  return index;
}

/// Gives every process the nodes of whole blocks, if there are enough of them.
void give_whole_blocks(DM nodes, const Grid<2>& grid, bool wraps) {
  constexpr const char* what = "distributing the nodes over the processes";
  const auto division = BlockDivision::among(parallel::ranks(), grid.cells, wraps);
  if (!division) return;
  const auto [across, up] = division->processes();
  const std::vector<PetscInt> columns = division->nodes_along(0), rows = division->nodes_along(1);
  check(DMDASetNumProcs(nodes, across, up, PETSC_DECIDE), what);
  check(DMDASetOwnershipRanges(nodes, columns.data(), rows.data(), nullptr), what);
}

/// Gives every process whole planes of nodes, if there are enough of them.
void give_whole_planes(DM nodes, const Index<3>& nodes_along) {
  constexpr const char* what = "distributing the nodes over the processes";
  const auto division = PlaneDivision::among(parallel::ranks(), nodes_along[2]);
  if (!division) return;
  std::vector<PetscInt> planes;
  planes.reserve(static_cast<std::size_t>(division->processes()));
  for (int process = 0; process < division->processes(); ++process) planes.push_back(division->planes(process));
  const PetscInt across = nodes_along[0], up = nodes_along[1];
  check(DMDASetNumProcs(nodes, 1, 1, division->processes()), what);
  check(DMDASetOwnershipRanges(nodes, &across, &up, planes.data()), what);
}

}  // namespace

template <int dim>
NodeLayout<dim>::NodeLayout(const Grid<dim>& grid, Boundary boundary) : grid_(grid), boundary_(boundary) {
  parallel::start();
  if (dim == 3 && parallel::ranks() == 1) {
    find_ranges_of_whole_box();
  } else {
    nodes_ = distributed();
    find_ranges_of_distributed();
  }
  cells_ = owned_;
  for (std::size_t axis = 0; axis < dim; ++axis) cells_.end[axis] = std::min(owned_.end[axis], grid_.cells[axis]);
  for (int node = 0; node < Shape::nodes; ++node) {
    offsets_[static_cast<std::size_t>(node)] =
        number_in<dim>(sum<dim>(seen_.begin, Shape::corner(node)), seen_.begin, seen_.end);
  }
  std::size_t index = 0;
  for_each_index(owned_.begin, owned_.end, [&](const Index<dim>& node) {
    for (int component = 0; component < dim; ++component, ++index) {
      if (is_held(node, component)) held_.push_back(index);
    }
  });
}

template <int dim>
NodeGrid NodeLayout<dim>::distributed() const {
  constexpr const char* what = "distributing the nodes over the processes";
  const auto end = boundary_ == Boundary::periodic ? DM_BOUNDARY_PERIODIC : DM_BOUNDARY_NONE;
  std::array<PetscInt, 3> sizes = {1, 1, 1};
  std::ranges::copy(nodes_along(), sizes.begin());
  NodeGrid nodes;
  check(DMDACreate(PETSC_COMM_WORLD, nodes.put()), what);
  check(DMSetDimension(nodes.get(), dim), what);
  check(DMDASetSizes(nodes.get(), sizes[0], sizes[1], sizes[2]), what);
  check(DMDASetBoundaryType(nodes.get(), end, end, dim > 2 ? end : DM_BOUNDARY_NONE), what);
  check(DMDASetDof(nodes.get(), dim), what);
  check(DMDASetStencilType(nodes.get(), DMDA_STENCIL_BOX), what);
  check(DMDASetStencilWidth(nodes.get(), 1), what);
  if constexpr (dim == 2) {
    give_whole_blocks(nodes.get(), grid_, boundary_ == Boundary::periodic);
  } else {
    give_whole_planes(nodes.get(), nodes_along());
  }
  check(DMSetUp(nodes.get()), what);
  return nodes;
}

template <int dim>
void NodeLayout<dim>::find_ranges_of_distributed() {
  const auto range = [&](auto&& corners) {
    std::array<PetscInt, 3> begin{}, size{};
    check(corners(nodes_.get(), &begin[0], &begin[1], &begin[2], &size[0], &size[1], &size[2]),
          "distributing the nodes over the processes");
    Range nodes;
    for (std::size_t axis = 0; axis < dim; ++axis) {
      nodes.begin[axis] = begin[axis];
      nodes.end[axis] = begin[axis] + size[axis];
    }
    return nodes;
  };
  owned_ = range(DMDAGetCorners);
  seen_ = range(DMDAGetGhostCorners);
}

/// The ranges of the grid of nodes that PETSc makes for one process.
template <int dim>
void NodeLayout<dim>::find_ranges_of_whole_box() noexcept {
  owned_.end = nodes_along();
  seen_ = owned_;
  if (boundary_ != Boundary::periodic) return;
  for (std::size_t axis = 0; axis < dim; ++axis) {
    --seen_.begin[axis];
    ++seen_.end[axis];
  }
}

template <int dim>
Index<dim> NodeLayout<dim>::nodes_along() const noexcept {
  return boundary_ == Boundary::periodic ? grid_.cells : grid_.nodes();
}

template <int dim>
std::int64_t NodeLayout<dim>::unknowns() const noexcept {
  std::int64_t unknowns = dim;
  for (const int along : nodes_along()) unknowns *= along;
  return unknowns;
}

template <int dim>
bool NodeLayout<dim>::is_held(const Index<dim>& node, int component) const noexcept {
  const auto is_at_end = [&](std::size_t axis) { return node[axis] == 0 || node[axis] == grid_.cells[axis]; };
  switch (boundary_) {
    case Boundary::displacement: {
      bool is_on_boundary = false;
      for (std::size_t axis = 0; axis < dim; ++axis) is_on_boundary = is_on_boundary || is_at_end(axis);
      return is_on_boundary;
    }
    case Boundary::traction: {
      // The lowest corner is at rest; the corner beyond it along axis d holds the components above d.
      auto corner = node;
      for (std::size_t axis = 0; axis < dim; ++axis) {
        if (corner[axis] != grid_.cells[axis]) continue;
        corner[axis] = 0;
        return corner == Index<dim>{} && component > static_cast<int>(axis);
      }
      return node == Index<dim>{};
    }
    case Boundary::periodic: {
      bool is_corner = true;
      for (std::size_t axis = 0; axis < dim; ++axis) is_corner = is_corner && is_at_end(axis);
      return is_corner;
    }
  }
  return false;
}

template <int dim>
typename NodeLayout<dim>::CellValues NodeLayout<dim>::held_mask(const Index<dim>& cell) const noexcept {
  CellValues free;
  for (int node = 0; node < Shape::nodes; ++node) {
    const auto corner = sum<dim>(cell, Shape::corner(node));
    for (int component = 0; component < dim; ++component) {
      free[dim * node + component] = is_held(corner, component) ? 0.0 : 1.0;
    }
  }
  return free;
}

template <int dim>
NodalVector NodeLayout<dim>::zeros() const {
  constexpr const char* what = "making a nodal vector";
  if (further_values_) return zeros_with_further_values();
  NodalVector nodal;
  if (nodes_.get() != nullptr) {
    check(DMCreateGlobalVector(nodes_.get(), nodal.put()), what);
  } else {
    const auto values = static_cast<PetscInt>(unknowns());
    check(VecCreate(PETSC_COMM_WORLD, nodal.put()), what);
    check(VecSetSizes(nodal.get(), values, values), what);
    check(VecSetBlockSize(nodal.get(), dim), what);
    check(VecSetType(nodal.get(), VECSTANDARD), what);
  }
  check(VecSet(nodal.get(), 0.0), what);
  return nodal;
}

template <int dim>
NodalVector NodeLayout<dim>::zeros_with_further_values() const {
  constexpr const char* what = "making a nodal vector";
  std::vector<PetscInt> natural;
  Grid<dim> grid = {.cells = nodes_along()};
  for_each_index(owned_.begin, owned_.end, [&](const Index<dim>& node) {
    const auto first = dim * static_cast<PetscInt>(grid.cell_index(node));
    for (int component = 0; component < dim; ++component) natural.push_back(first + component);
  });
  for (const auto number : *further_values_) natural.push_back(static_cast<PetscInt>(unknowns()) + number);
  NodalVector nodal;
  check(VecCreateMPI(PETSC_COMM_WORLD, static_cast<PetscInt>(natural.size()), PETSC_DETERMINE, nodal.put()), what);
  if (parallel::ranks() > 1) set_natural_indices(natural, nodal.get());
  check(VecSet(nodal.get(), 0.0), what);
  return nodal;
}

template <int dim>
NodalVector NodeLayout<dim>::local_zeros() const {
  constexpr const char* what = "making a nodal vector";
  NodalVector local;
  if (nodes_.get() != nullptr) {
    check(DMCreateLocalVector(nodes_.get(), local.put()), what);
  } else {
    PetscInt values = dim;
    for (std::size_t axis = 0; axis < dim; ++axis) values *= seen_.end[axis] - seen_.begin[axis];
    check(VecCreateSeq(PETSC_COMM_SELF, values, local.put()), what);
  }
  check(VecSet(local.get(), 0.0), what);
  return local;
}

template <int dim>
NodalVector NodeLayout<dim>::local_copy(Vec nodal) const {
  auto local = local_zeros();
  if (nodes_.get() != nullptr) {
    const OfNodes of_nodes(nodes_.get(), nodal, further_values_.has_value());
    check(DMGlobalToLocal(nodes_.get(), of_nodes.get(), INSERT_VALUES, local.get()), "exchanging nodal values");
    return local;
  }
  const ReadValues values(nodal);
  const WriteValues copies(local.get());
  for_seen_nodes([&](std::size_t in_local, std::size_t in_nodal) {
    std::copy_n(values.data() + in_nodal, dim, copies.data() + in_local);
  });
  return local;
}

template <int dim>
template <class Action>
void NodeLayout<dim>::for_seen_nodes(const Action& action) const {
  std::size_t in_local = 0;
  for_each_index(seen_.begin, seen_.end, [&](const Index<dim>& node) {
    action(in_local, nodal_index_of(node));
    in_local += dim;
  });
}

/// Index of the lowest node of a cell among the nodes that this process sees.
template <int dim>
int NodeLayout<dim>::lowest_node_of(const Index<dim>& cell) const noexcept {
  return number_in<dim>(cell, seen_.begin, seen_.end);
}

// The nodes of a cell come in pairs that are neighbours along the first axis.

template <int dim>
typename NodeLayout<dim>::CellValues NodeLayout<dim>::cell_values(const Index<dim>& cell,
                                                                  const double* local) const noexcept {
  const int lowest = lowest_node_of(cell);
  CellValues values;
  for (int node = 0; node < Shape::nodes; node += 2) {
    values.template segment<2 * dim>(dim * node) = Eigen::Map<const Eigen::Matrix<double, 2 * dim, 1>>(
        local + dim * (lowest + offsets_[static_cast<std::size_t>(node)]));
  }
  return values;
}

template <int dim>
std::array<std::size_t, CellShape<dim>::nodes> NodeLayout<dim>::indices_of(const Index<dim>& cell) const noexcept {
  std::array<std::size_t, Shape::nodes> indices{};
  for (std::size_t n = 0; n < indices.size(); ++n) {
    const int index = dim * (lowest_node_of(cell) + offsets_[n]);
    indices[n] = static_cast<std::size_t>(index);
  }
  return indices;
}

template <int dim>
std::size_t NodeLayout<dim>::nodal_index_of(Index<dim> node) const noexcept {
  for (std::size_t axis = 0; axis < dim; ++axis) {
    if (node[axis] < 0) node[axis] += owned_.end[axis];
    if (node[axis] >= owned_.end[axis]) node[axis] -= owned_.end[axis];
  }
  const int index = dim * number_in<dim>(node, owned_.begin, owned_.end);
  return static_cast<std::size_t>(index);
}

template <int dim>
std::array<std::size_t, CellShape<dim>::nodes> NodeLayout<dim>::nodal_indices_of(
    const Index<dim>& cell) const noexcept {
  std::array<std::size_t, Shape::nodes> indices{};
  for (std::size_t n = 0; n < indices.size(); ++n) {
    indices[n] = nodal_index_of(sum<dim>(cell, Shape::corner(static_cast<int>(n))));
  }
  return indices;
}

template <int dim>
void NodeLayout<dim>::add_to_cell(const Index<dim>& cell, const CellValues& values, double* local) const noexcept {
  const int lowest = lowest_node_of(cell);
  for (int node = 0; node < Shape::nodes; node += 2) {
    Eigen::Map<Eigen::Matrix<double, 2 * dim, 1>>(local + dim * (lowest + offsets_[static_cast<std::size_t>(node)])) +=
        values.template segment<2 * dim>(dim * node);
  }
}

template <int dim>
void NodeLayout<dim>::sum_up(Vec local, Vec nodal) const {
  if (nodes_.get() != nullptr) {
    const OfNodes of_nodes(nodes_.get(), nodal, further_values_.has_value());
    check(DMLocalToGlobal(nodes_.get(), local, ADD_VALUES, of_nodes.get()), "adding nodal forces");
  } else {
    const ReadValues added(local);
    const WriteValues values(nodal);
    for_seen_nodes([&](std::size_t in_local, std::size_t in_nodal) {
      for (std::size_t i = 0; i < dim; ++i) values.data()[in_nodal + i] += added.data()[in_local + i];
    });
  }
  hold(nodal);
}

template <int dim>
void NodeLayout<dim>::hold(Vec nodal) const {
  const WriteValues values(nodal);
  for (const auto index : held_) values.data()[index] = 0.0;
}

template <int dim>
Matrix NodeLayout<dim>::make_matrix() const {
  const auto nodes = distributed();
  Matrix matrix;
  check(DMSetMatType(nodes.get(), MATAIJ), "making the stiffness matrix");
  check(DMCreateMatrix(nodes.get(), matrix.put()), "making the stiffness matrix");
  check(MatSetOption(matrix.get(), MAT_SPD, PETSC_TRUE), "making the stiffness matrix");
  return matrix;
}

template <int dim>
void NodeLayout<dim>::add_to_matrix(const Index<dim>& cell, const typename Shape::Stiffness& stiffness,
                                    Mat matrix) const {
  auto nodes = offsets_;
  for (int& node : nodes) node += lowest_node_of(cell);
  // The matrix is symmetric, so that the order of rows and columns does not matter.
  check(MatSetValuesBlockedLocal(matrix, Shape::nodes, nodes.data(), Shape::nodes, nodes.data(), stiffness.data(),
                                 ADD_VALUES),
        "assembling the stiffness matrix");
}

template <int dim>
void NodeLayout<dim>::attach_rigid_motions(Mat matrix) const {
  constexpr const char* what = "setting up the rigid motions";
  const auto nodes = distributed();
  std::array<double, 3> end{};
  std::ranges::copy(grid_.cells, end.begin());
  check(DMDASetUniformCoordinates(nodes.get(), 0.0, end[0], 0.0, end[1], 0.0, end[2]), what);
  Vec coordinates = nullptr;
  check(DMGetCoordinates(nodes.get(), &coordinates), what);
  PetscHandle<MatNullSpace, MatNullSpaceDestroy> rigid_motions;
  check(MatNullSpaceCreateRigidBody(coordinates, rigid_motions.put()), what);
  check(MatSetNearNullSpace(matrix, rigid_motions.get()), what);
}

template class NodeLayout<2>;
template class NodeLayout<3>;

}  // namespace breccia::quasistatic

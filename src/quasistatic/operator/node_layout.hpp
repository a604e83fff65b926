#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/grid.hpp"

#include "discretisation/cell_shape.hpp"
#include "quasistatic/operator/petsc_handle.hpp"

namespace breccia::quasistatic {

/// The nodes of a grid of cells under one boundary condition, distributed over the processes: the components that are
/// held at zero, and the positions of the values of a node in nodal vectors.
template <int dim>
class NodeLayout {
 public:
  using Shape = CellShape<dim>;
  using CellValues = typename Shape::Values;

  NodeLayout(const Grid<dim>& grid, Boundary boundary);

  [[nodiscard]] const Grid<dim>& grid() const noexcept { return grid_; }
  [[nodiscard]] Boundary boundary() const noexcept { return boundary_; }
  /// Number of nodal components, the held ones included.
  [[nodiscard]] std::int64_t unknowns() const noexcept;
  /// Lets nodal vectors have further values on every process, behind those of its nodes: their numbers, which follow
  /// those of all components of nodes, in an order that does not depend on the processes.
  void append(std::vector<std::int32_t> numbers_of_values) { further_values_ = std::move(numbers_of_values); }
  /// Whether this component of a node is held at zero.
  [[nodiscard]] bool is_held(const Index<dim>& node, int component) const noexcept;
  /// A mask of the components of a cell's nodes: 0 for held components, 1 for the other ones.
  [[nodiscard]] CellValues held_mask(const Index<dim>& cell) const noexcept;

  using Range = IndexRange<dim>;
  /// The cells of this process: those whose lowest node belongs to it.
  [[nodiscard]] const Range& cells() const noexcept { return cells_; }
  /// The nodes of this process, in the order of the values of nodal vectors.
  [[nodiscard]] const Range& own_nodes() const noexcept { return owned_; }
  /// The nodes of this process and their neighbours, in the order of the values of local vectors.
  [[nodiscard]] const Range& seen_nodes() const noexcept { return seen_; }

  /// Calls action(cell) for the cells of this process: those whose lowest node belongs to it.
  template <class Action>
  void for_cells(Action&& action) const {
    for_each_index(cells_.begin, cells_.end, action);
  }
  /// Calls action(node, components) for the nodes of this process, to write to a nodal vector.
  template <class Action>
  void for_nodes(Vec nodal, Action&& action) const {
    constexpr const char* what = "writing nodal values";
    double* values = nullptr;
    check(VecGetArray(nodal, &values), what);
    double* components = values;
    for_each_index(owned_.begin, owned_.end, [&](const Index<dim>& node) {
      action(node, components);
      components += dim;
    });
    check(VecRestoreArray(nodal, &values), what);
  }

  /// A nodal vector of zeros.
  [[nodiscard]] NodalVector zeros() const;
  /// A nodal vector of zeros with the nodes of neighbouring processes, to which the cells of this process add.
  [[nodiscard]] NodalVector local_zeros() const;
  /// The values of a nodal vector with those of the nodes of neighbouring processes.
  [[nodiscard]] NodalVector local_copy(Vec nodal) const;
  /// The values at the nodes of a cell, from the values of a local vector, which has the nodes of neighbouring
  /// processes.
  [[nodiscard]] CellValues cell_values(const Index<dim>& cell, const double* local) const noexcept;
  /// Indices of the first components of the nodes of a cell among the values with the nodes of neighbouring processes.
  [[nodiscard]] std::array<std::size_t, Shape::nodes> indices_of(const Index<dim>& cell) const noexcept;
  /// Indices of the first components of the nodes of a cell in a nodal vector of a single process.
  [[nodiscard]] std::array<std::size_t, Shape::nodes> nodal_indices_of(const Index<dim>& cell) const noexcept;
  /// Index of the first component of a node that a single process sees, in a nodal vector. In a periodic box the nodes
  /// before the first ones are the last ones, and the nodes behind the last ones are the first.
  [[nodiscard]] std::size_t nodal_index_of(Index<dim> node) const noexcept;
  /// Adds values to those of a local vector at the nodes of a cell.
  void add_to_cell(const Index<dim>& cell, const CellValues& values, double* local) const noexcept;
  /// Adds the values in the local vectors of all processes to a nodal vector, and sets its held components to zero.
  void sum_up(Vec local, Vec nodal) const;
  /// Sets the held components of a nodal vector to zero.
  void hold(Vec nodal) const;

  /// A sparse matrix of nodes that share a cell, without values.
  [[nodiscard]] Matrix make_matrix() const;
  /// Adds the stiffness of a cell to a matrix of make_matrix().
  void add_to_matrix(const Index<dim>& cell, const typename Shape::Stiffness& stiffness, Mat matrix) const;
  /// Attaches the rigid motions to a matrix as its near null space, for algebraic multigrid.
  void attach_rigid_motions(Mat matrix) const;

 private:
  /// Number of the nodes of the box along each axis; in a periodic box without the last one.
  [[nodiscard]] Index<dim> nodes_along() const noexcept;
  [[nodiscard]] NodalVector zeros_with_further_values() const;
  /// The nodes as PETSc distributes them.
  [[nodiscard]] NodeGrid distributed() const;
  void find_ranges_of_distributed();
  void find_ranges_of_whole_box() noexcept;
  /// Calls action(index in a local vector, index in a nodal vector) for the nodes that a single process sees.
  template <class Action>
  void for_seen_nodes(const Action& action) const;
  [[nodiscard]] int lowest_node_of(const Index<dim>& cell) const noexcept;

  Grid<dim> grid_;
  Boundary boundary_;
  std::optional<std::vector<std::int32_t>> further_values_;
  NodeGrid nodes_;  ///< grid of PETSc; empty for a cube on one process, where its lists would take more memory than a
                    ///< nodal vector
  Range owned_;     ///< nodes that belong to this process
  Range cells_;     ///< cells whose lowest node belongs to this process
  Range seen_;      ///< nodes of this process and their neighbours
  std::array<int, std::size_t{1} << dim>
      offsets_{};                  ///< indices of the nodes of a cell among those seen, from the lowest
  std::vector<std::size_t> held_;  ///< indices of the held components among those of this process
};

extern template class NodeLayout<2>;
extern template class NodeLayout<3>;

}  // namespace breccia::quasistatic

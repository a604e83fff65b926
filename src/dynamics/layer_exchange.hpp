#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <mpi.h>

#include "breccia/discretisation/grid.hpp"
#include "breccia/parallel/ordered_values.hpp"

#include "dynamics/cell_row_kernel.hpp"

namespace breccia::dynamics {

/// The layers of cells of this process. The layers of all processes follow one another in the order of the processes.
/// Without mpirun the process has all layers, and MPI is not started.
template <int dim>
[[nodiscard]] IndexRange<dim> own_layers(const Grid<dim>& grid);

/// The layers of cells of this process, if mpirun has started several, and the messages between processes. A process
/// that runs alone has all layers, and MPI is not started for it.
template <int dim>
class LayerExchange {
 public:
  /// Deals the layers to the processes in order. In a box that wraps, the first and the last process are neighbours.
  /// Throws InputError when there are more processes than layers.
  LayerExchange(const Grid<dim>& grid, bool wraps);

  /// Layers of cells [first, end).
  [[nodiscard]] int first() const noexcept { return first_of(rank_); }
  [[nodiscard]] int end() const noexcept { return first_of(rank_ + 1); }
  /// Layers of nodes [first, end_of_nodes): the layer between two processes counts as one of the upper process.
  [[nodiscard]] int end_of_nodes() const noexcept { return end() == layers_ ? layers_ + 1 : end(); }
  [[nodiscard]] bool has_neighbours() const noexcept { return wraps_ || ranks_ > 1; }

  /// Starts to send the forces on the lowest nodes to the process below, and to receive the forces of both neighbours.
  void begin(const LayerForces<dim>& lowest);
  /// Sends the forces on the highest nodes to the process above, and waits until the forces from both neighbours are
  /// there. On a side without a neighbour no forces are written.
  void finish(const LayerForces<dim>& highest, const LayerForces<dim>& from_below, const LayerForces<dim>& from_above);

  /// Completes a short list that has the same number of values for each layer of nodes on every process. Before the
  /// call each process has the values of its own layers.
  void gather_node_layers(std::span<double> values) const;

  /// The share of this process in a list that consists of the values of one process after the other.
  struct OwnShare {
    parallel::OrderedPlaces own;
    std::size_t count = 0;  ///< number of the values of all processes
  };
  [[nodiscard]] OwnShare share_of(std::size_t own) const;

 private:
  [[nodiscard]] int first_of(int rank) const noexcept;
  [[nodiscard]] int process_above() const noexcept;
  [[nodiscard]] int process_below() const noexcept;

  int layers_;
  bool wraps_;
  int rank_ = 0;
  int ranks_ = 1;
  /// Sums of x, then of y, and so on, over a layer of nodes.
  using Message = std::vector<double>;
  Message up_, down_, from_below_, from_above_;
  std::array<MPI_Request, 4> requests_{};
};

}  // namespace breccia::dynamics

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <mpi.h>

#include "breccia/discretisation/discretisation.hpp"

#include "cell_row_kernel.hpp"

namespace breccia::dynamics {

/// The rows of cells of this process, where mpirun has started several, and what these tell each other. A process
/// alone has all rows, and MPI is not started for it.
class RowExchange {
 public:
  /// Deals the rows in order. In a box that wraps, the first and the last process are neighbours. Rows of forces have
  /// so many values. Throws InputError when there are more processes than rows.
  RowExchange(const Grid& grid, bool wraps, std::size_t length);

  /// Rows of cells [first, end).
  [[nodiscard]] int first() const noexcept { return first_of(rank_); }
  [[nodiscard]] int end() const noexcept { return first_of(rank_ + 1); }
  [[nodiscard]] bool has_neighbours() const noexcept { return wraps_ || ranks_ > 1; }

  /// Begins to hand the forces on the lowest nodes to the process below and to take those of both neighbours.
  void begin(const RowForces& lowest);
  /// Hands the forces on the highest nodes to the process above and waits for those of the neighbours. Leaves alone
  /// what no neighbour would send. Those of the left and the right cells come as one sum, in the place of the left
  /// ones, and what is in the place of the right ones must be -0, with which a sum keeps its bits.
  void finish(const RowForces& highest, const RowForces& from_below, const RowForces& from_above);

  /// Completes a list that holds so many values for each row of cells, or of nodes, of which this process knows its
  /// own.
  void gather_cell_rows(std::span<double> values) const;
  void gather_node_rows(std::span<double> values) const;

  /// What all processes have of something that each knows for its own rows, in their order; on the first process, where
  /// it is put into `all`. A process alone gets its own back.
  [[nodiscard]] std::span<const double> collect(std::span<const double> own, std::vector<double>& all) const;
  /// Where the share of this process begins in it, and how long the whole is.
  struct Place {
    std::size_t begin;
    std::size_t size;
  };
  [[nodiscard]] Place place_of(std::size_t own) const;

 private:
  [[nodiscard]] int first_of(int rank) const noexcept;
  [[nodiscard]] int process_above() const noexcept;
  [[nodiscard]] int process_below() const noexcept;
  void gather(std::span<double> values, int rows) const;

  int rows_;
  bool wraps_;
  int rank_ = 0;
  int ranks_ = 1;
  /// Sums of x, then of y, along a row of nodes.
  using Message = std::vector<double>;
  Message up_, down_, from_below_, from_above_;
  std::array<MPI_Request, 4> requests_{};
};

}  // namespace breccia::dynamics

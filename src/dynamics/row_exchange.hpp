#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "breccia/mpm/discretisation.hpp"

#include "cell_row_kernel.hpp"

namespace breccia::dynamics {

/// The rows of cells of this process, where mpirun has started several, and what these tell each other. A process
/// alone has all rows, and MPI is not started for it.
class RowExchange {
 public:
  /// Deals the rows in order. In a box that wraps, the first and the last process are neighbours.
  /// Throws InputError when there are more processes than rows.
  RowExchange(const Grid& grid, bool wraps);

  /// Rows of cells [first, end).
  [[nodiscard]] int first() const noexcept { return first_of(rank_); }
  [[nodiscard]] int end() const noexcept { return first_of(rank_ + 1); }
  [[nodiscard]] bool has_neighbours() const noexcept { return wraps_ || ranks_ > 1; }

  /// Hands the forces on the highest nodes to the process above and those on the lowest to the one below, and takes
  /// theirs, rows of so many values. Leaves alone what no neighbour would send.
  void swap(const RowForces& highest, const RowForces& lowest, const RowForces& from_below, const RowForces& from_above,
            int length) const;

  /// Completes a list that holds so many values for each row of cells, or of nodes, of which this process knows its
  /// own.
  void gather_cell_rows(std::span<double> values) const;
  void gather_node_rows(std::span<double> values) const;

  /// What all processes have of something that each knows for its own rows, in their order; on the first process.
  [[nodiscard]] std::vector<double> collect(std::span<const double> own) const;
  /// Where the share of this process begins in it, and how long the whole is.
  struct Place {
    std::size_t begin;
    std::size_t size;
  };
  [[nodiscard]] Place place_of(std::size_t own) const;

 private:
  [[nodiscard]] int first_of(int rank) const noexcept;
  void gather(std::span<double> values, int rows) const;

  int rows_;
  bool wraps_;
  int rank_ = 0;
  int ranks_ = 1;
};

}  // namespace breccia::dynamics

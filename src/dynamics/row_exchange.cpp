#include "row_exchange.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <mpi.h>

#include "breccia/error.hpp"
#include "breccia/parallel/communicator.hpp"
#include "breccia/parallel/session.hpp"

namespace breccia::dynamics {
namespace {

std::array<double*, 4> components(const RowForces& forces) {
  return {forces.left_x, forces.left_y, forces.right_x, forces.right_y};
}

}  // namespace

RowExchange::RowExchange(const Grid& grid, bool wraps) : rows_(grid.rows), wraps_(wraps) {
  if (!parallel::is_under_mpirun()) return;
  parallel::start();
  rank_ = parallel::rank();
  ranks_ = parallel::ranks();
  if (ranks_ > rows_) {
    throw InputError(fmt::format("dynamic run: {} processes are too many for {} rows of cells", ranks_, rows_));
  }
}

int RowExchange::first_of(int rank) const noexcept {
  return static_cast<int>(static_cast<std::int64_t>(rows_) * rank / ranks_);
}

void RowExchange::swap(const RowForces& highest, const RowForces& lowest, const RowForces& from_below,
                       const RowForces& from_above, int length) const {
  const auto up = components(highest), down = components(lowest);
  const auto below = components(from_below), above = components(from_above);
  if (ranks_ == 1) {
    for (std::size_t i = 0; i < 4; ++i) {
      std::copy_n(up[i], length, below[i]);
      std::copy_n(down[i], length, above[i]);
    }
    return;
  }
  const int neighbour_above = rank_ + 1 < ranks_ ? rank_ + 1 : wraps_ ? 0 : MPI_PROC_NULL;
  const int neighbour_below = rank_ > 0 ? rank_ - 1 : wraps_ ? ranks_ - 1 : MPI_PROC_NULL;
  for (std::size_t i = 0; i < 4; ++i) {
    MPI_Sendrecv(up[i], length, MPI_DOUBLE, neighbour_above, 0, below[i], length, MPI_DOUBLE, neighbour_below, 0,
                 parallel::communicator(), MPI_STATUS_IGNORE);
    MPI_Sendrecv(down[i], length, MPI_DOUBLE, neighbour_below, 1, above[i], length, MPI_DOUBLE, neighbour_above, 1,
                 parallel::communicator(), MPI_STATUS_IGNORE);
  }
}

void RowExchange::gather_cell_rows(std::span<double> values) const {
  gather(values, rows_);
}

void RowExchange::gather_node_rows(std::span<double> values) const {
  gather(values, rows_ + 1);
}

void RowExchange::gather(std::span<double> values, int rows) const {
  if (ranks_ == 1) return;
  const auto per_row = static_cast<int>(values.size()) / rows;
  std::vector<int> counts, begins;
  for (int rank = 0; rank < ranks_; ++rank) {
    // The highest row of nodes goes with the last process.
    const int end = rank + 1 < ranks_ ? first_of(rank + 1) : rows;
    begins.push_back(first_of(rank) * per_row);
    counts.push_back((end - first_of(rank)) * per_row);
  }
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, values.data(), counts.data(), begins.data(), MPI_DOUBLE,
                 parallel::communicator());
}

std::vector<double> RowExchange::collect(std::span<const double> own) const {
  if (ranks_ == 1) return {own.begin(), own.end()};
  const auto count = static_cast<int>(own.size());
  std::vector<int> counts(static_cast<std::size_t>(ranks_)), begins(counts.size());
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, parallel::communicator());
  std::exclusive_scan(counts.begin(), counts.end(), begins.begin(), 0);
  std::vector<double> all(rank_ == 0 ? static_cast<std::size_t>(begins.back() + counts.back()) : 0);
  MPI_Gatherv(own.data(), count, MPI_DOUBLE, all.data(), counts.data(), begins.data(), MPI_DOUBLE, 0,
              parallel::communicator());
  return all;
}

RowExchange::Place RowExchange::place_of(std::size_t own) const {
  if (ranks_ == 1) return {0, own};
  std::vector<std::uint64_t> counts(static_cast<std::size_t>(ranks_));
  const std::uint64_t count = own;
  MPI_Allgather(&count, 1, MPI_UINT64_T, counts.data(), 1, MPI_UINT64_T, parallel::communicator());
  return {std::accumulate(counts.begin(), counts.begin() + rank_, std::uint64_t{0}),
          std::accumulate(counts.begin(), counts.end(), std::uint64_t{0})};
}

}  // namespace breccia::dynamics

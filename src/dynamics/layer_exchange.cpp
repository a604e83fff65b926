#include "dynamics/layer_exchange.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/joined_discretisation.hpp"
#include "dynamics/nodal_field.hpp"
#include "parallel/communicator.hpp"
#include "parallel/session.hpp"

namespace breccia::dynamics {
namespace {

constexpr int upwards = 0, downwards = 1;

template <int dim>
void pack(const LayerForces<dim>& forces, std::vector<double>& message) {
  const auto length = message.size() / dim;
  for (std::size_t c = 0; c < dim; ++c) std::copy_n(forces.of_axis[c], length, message.data() + c * length);
}

template <int dim>
void unpack(const std::vector<double>& message, const LayerForces<dim>& forces) {
  const auto length = message.size() / dim;
  for (std::size_t c = 0; c < dim; ++c) std::copy_n(message.data() + c * length, length, forces.of_axis[c]);
}

}  // namespace

template <int dim>
IndexRange<dim> own_layers(const Grid<dim>& grid) {
  if (!parallel::is_under_mpirun()) return grid.all_cells();
  parallel::start();
  return grid.cells_of(layers_of_part(grid.cells.back(), parallel::rank(), parallel::ranks()));
}

template <int dim>
LayerExchange<dim>::LayerExchange(const Grid<dim>& grid, bool wraps) : layers_(grid.cells.back()), wraps_(wraps) {
  for (auto* message : {&up_, &down_, &from_below_, &from_above_})
    message->resize(dim * NodalField<dim>::length_of_layer(grid));
  if (!parallel::is_under_mpirun()) return;
  parallel::start();
  rank_ = parallel::rank();
  ranks_ = parallel::ranks();
  if (ranks_ > layers_) {
    throw InputError(fmt::format("dynamic run: {} processes are too many for {} {} of cells", ranks_, layers_,
                                 dim == 2 ? "rows" : "planes"));
  }
}

template <int dim>
int LayerExchange<dim>::first_of(int rank) const noexcept {
  return layers_of_part(layers_, rank, ranks_).begin;
}

template <int dim>
int LayerExchange<dim>::process_above() const noexcept {
  return rank_ + 1 < ranks_ ? rank_ + 1 : wraps_ ? 0 : MPI_PROC_NULL;
}

template <int dim>
int LayerExchange<dim>::process_below() const noexcept {
  return rank_ > 0 ? rank_ - 1 : wraps_ ? ranks_ - 1 : MPI_PROC_NULL;
}

template <int dim>
void LayerExchange<dim>::begin(const LayerForces<dim>& lowest) {
  pack(lowest, down_);
  if (ranks_ == 1) return;
  const auto length = static_cast<int>(down_.size());
  MPI_Irecv(from_below_.data(), length, MPI_DOUBLE, process_below(), upwards, parallel::communicator(), &requests_[0]);
  MPI_Irecv(from_above_.data(), length, MPI_DOUBLE, process_above(), downwards, parallel::communicator(),
            &requests_[1]);
  MPI_Isend(down_.data(), length, MPI_DOUBLE, process_below(), downwards, parallel::communicator(), &requests_[2]);
}

template <int dim>
void LayerExchange<dim>::finish(const LayerForces<dim>& highest, const LayerForces<dim>& from_below,
                                const LayerForces<dim>& from_above) {
  pack(highest, up_);
  if (ranks_ == 1) {
    unpack(up_, from_below);
    unpack(down_, from_above);
    return;
  }
  MPI_Isend(up_.data(), static_cast<int>(up_.size()), MPI_DOUBLE, process_above(), upwards, parallel::communicator(),
            &requests_[3]);
  MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  if (process_below() != MPI_PROC_NULL) unpack(from_below_, from_below);
  if (process_above() != MPI_PROC_NULL) unpack(from_above_, from_above);
}

template <int dim>
void LayerExchange<dim>::gather_node_layers(std::span<double> values) const {
  if (ranks_ == 1) return;
  const int per_layer = static_cast<int>(values.size()) / (layers_ + 1);
  std::vector<int> counts, begins;
  for (int rank = 0; rank < ranks_; ++rank) {
    // The highest layer of nodes belongs to the last process.
    const int end = rank + 1 < ranks_ ? first_of(rank + 1) : layers_ + 1;
    begins.push_back(per_layer * first_of(rank));
    counts.push_back(per_layer * (end - first_of(rank)));
  }
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, values.data(), counts.data(), begins.data(), MPI_DOUBLE,
                 parallel::communicator());
}

template <int dim>
typename LayerExchange<dim>::OwnShare LayerExchange<dim>::share_of(std::size_t own) const {
  if (ranks_ == 1) return {parallel::consecutive_places(0, own), own};
  std::vector<std::uint64_t> counts(static_cast<std::size_t>(ranks_));
  const std::uint64_t count = own;
  MPI_Allgather(&count, 1, MPI_UINT64_T, counts.data(), 1, MPI_UINT64_T, parallel::communicator());
  const auto first = std::accumulate(counts.begin(), counts.begin() + rank_, std::uint64_t{0});
  return {parallel::consecutive_places(first, own), std::accumulate(counts.begin(), counts.end(), std::uint64_t{0})};
}

template IndexRange<2> own_layers(const Grid<2>&);
template IndexRange<3> own_layers(const Grid<3>&);
template class LayerExchange<2>;
template class LayerExchange<3>;

}  // namespace breccia::dynamics

#include "quasistatic/solvers/lattice/plane_exchange.hpp"

#include <algorithm>

#include "parallel/communicator.hpp"
#include "parallel/session.hpp"

namespace breccia::quasistatic {
namespace {

constexpr int tag = 0;

}  // namespace

PlaneExchange::PlaneExchange(const NodeLattice& lattice) : lattice_(lattice) {
  const int rank = parallel::rank(), ranks = parallel::ranks();
  const bool is_alone = lattice.planes == lattice.nodes[2];
  if (is_alone) return;
  if (lattice.has_plane_above()) above_ = (rank + 1) % ranks;
  if (lattice.first_plane > 0 || lattice.is_periodic()) below_ = (rank + ranks - 1) % ranks;
  const auto plane = lattice.arrays.plane;
  MPI_Type_vector(3, static_cast<int>(plane), static_cast<int>(lattice.size()), MPI_DOUBLE, &components_);
  MPI_Type_commit(&components_);
  if (below_ != MPI_PROC_NULL) from_below_.resize(3 * plane);
}

PlaneExchange::~PlaneExchange() {
  if (components_ != MPI_DATATYPE_NULL) MPI_Type_free(&components_);
}

void PlaneExchange::copy_from_above(NodalField& field) const {
  if (components_ == MPI_DATATYPE_NULL) return;
  double* first = field.all().data();
  double* above = first + static_cast<std::size_t>(lattice_.planes) * lattice_.arrays.plane;
  MPI_Sendrecv(first, 1, components_, below_, tag, above, 1, components_, above_, tag, parallel::communicator(),
               MPI_STATUS_IGNORE);
}

void PlaneExchange::add_to_above(NodalField& field) {
  if (components_ == MPI_DATATYPE_NULL) return;
  const auto plane = lattice_.arrays.plane, behind = static_cast<std::size_t>(lattice_.planes) * plane;
  MPI_Sendrecv(field.all().data() + behind, 1, components_, above_, tag, from_below_.data(),
               static_cast<int>(from_below_.size()), MPI_DOUBLE, below_, tag, parallel::communicator(),
               MPI_STATUS_IGNORE);
  const double* received = from_below_.data();
  for (double* component : field.components()) {
    if (below_ != MPI_PROC_NULL) {
      for (std::size_t index = 0; index < plane; ++index) component[index] += *received++;
    }
    if (above_ != MPI_PROC_NULL) std::fill_n(component + behind, plane, 0.0);
  }
}

}  // namespace breccia::quasistatic

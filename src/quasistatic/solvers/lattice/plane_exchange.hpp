#pragma once

#include <vector>

#include <mpi.h>

#include "quasistatic/solvers/lattice/nodal_field.hpp"

namespace breccia::quasistatic {

/// The exchange of planes of nodes between processes whose planes are neighbours. In a periodic box the last process is
/// below the first one. On one process the exchange does nothing. All processes of the group call the exchanges
/// together.
class PlaneExchange {
 public:
  explicit PlaneExchange(const NodeLattice& lattice);
  PlaneExchange(const PlaneExchange&) = delete;
  PlaneExchange& operator=(const PlaneExchange&) = delete;
  PlaneExchange(PlaneExchange&&) = delete;
  PlaneExchange& operator=(PlaneExchange&&) = delete;
  ~PlaneExchange();

  /// Sets the plane behind those of this process to the first plane of the process above.
  void copy_from_above(NodalField& field) const;
  /// Adds the plane behind those of this process to the first plane of the process above, and sets it to zero here.
  void add_to_above(NodalField& field);

 private:
  NodeLattice lattice_;
  int below_ = MPI_PROC_NULL, above_ = MPI_PROC_NULL;  ///< ranks of processes, or MPI_PROC_NULL
  MPI_Datatype components_ = MPI_DATATYPE_NULL;        ///< all components of a plane of a field
  std::vector<double> from_below_;                     ///< the components of a received plane, one after the other
};

}  // namespace breccia::quasistatic

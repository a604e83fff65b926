#include "quasistatic/solvers/lattice/lattice_preconditioner.hpp"

#include "quasistatic/solvers/lattice/periodic_preconditioner.hpp"
#include "quasistatic/solvers/lattice/wall_preconditioner.hpp"

namespace breccia::quasistatic {

std::unique_ptr<LatticePreconditioner> make_lattice_preconditioner(const NodeLattice& lattice, int threads) {
  if (lattice.is_periodic()) return std::make_unique<PeriodicPreconditioner>(lattice, threads);
  return std::make_unique<WallPreconditioner>(lattice, threads);
}

}  // namespace breccia::quasistatic

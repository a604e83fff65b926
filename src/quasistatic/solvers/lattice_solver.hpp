#pragma once

#include <memory>

#include "solvers/elastic_solver.hpp"
#include "solvers/lattice_boundary.hpp"
#include "solvers/lattice_field.hpp"
#include "solvers/lattice_preconditioner.hpp"

namespace breccia::quasistatic {

/// Conjugate gradients in 3 dimensions on one process, without any assembled matrix: the forces of the cells come row
/// by row, and the preconditioner is the inverse of a box of one material by fast transforms (theory, section 18).
/// Besides the moduli of the cells it keeps four numbers for each unknown.
class LatticeSolver final : public ElasticSolver<3> {
 public:
  LatticeSolver(const ElasticOperator<3>& elastic_operator, const LinearOptions& options);

  /// Does nothing: the preconditioner follows the moduli.
  void update_preconditioner() override {}

 private:
  void update_stiffness(std::span<const Moduli> moduli) override;
  End iterate(NodalVector on_nodes, Displacement& displacement) override;

  /// The fields of an iteration.
  struct State {
    explicit State(const NodeLattice& lattice)
        : displacement(lattice), residual(lattice), direction(lattice), work(lattice) {}

    LatticeField displacement, residual, direction, work;
    double energy = 0.0;  ///< twice the energy of the displacement, gained so far
  };

  /// Iterates until the displacement is accurate. Returns the norm of the residual, which follows by recurrence.
  double iterate(State& state, int most_iterations);
  /// work = K direction
  void multiply(State& state) const;
  [[nodiscard]] bool is_accurate(double error, double energy) const noexcept;

  NodeLattice lattice_;
  LatticeBoundary boundary_;
  CellSweep sweep_;
  int threads_;
  double energy_tolerance_;
  LatticeSums sums_;
  std::unique_ptr<LatticePreconditioner> preconditioner_;
  CellModuli cells_;
  Moduli reference_{};  ///< of the preconditioner [Pa]
};

}  // namespace breccia::quasistatic

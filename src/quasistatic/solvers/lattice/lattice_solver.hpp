#pragma once

#include <memory>
#include <string>

#include "quasistatic/solvers/elastic_solver.hpp"
#include "quasistatic/solvers/lattice/lattice_boundary.hpp"
#include "quasistatic/solvers/lattice/lattice_preconditioner.hpp"
#include "quasistatic/solvers/lattice/nodal_field.hpp"

namespace breccia::quasistatic {

/// Conjugate gradients in 3 dimensions without any assembled matrix: the forces of the cells are found row by row, and
/// the preconditioner is the inverse of a box of one material by fast transforms (theory, section 18). In addition to
/// the moduli of the cells the solver keeps five numbers for each unknown, or six on several processes, each of which
/// has whole planes.
class LatticeSolver final : public ElasticSolver<3> {
 public:
  LatticeSolver(const ElasticOperator<3>& elastic_operator, const LinearOptions& options);

  /// Does nothing: the preconditioner follows the moduli.
  void update_preconditioner() override {}

 private:
  void update_stiffness(std::span<const Moduli> moduli) override;
  [[nodiscard]] std::vector<Moduli> solvable(std::span<const Moduli> moduli) const override {
    return {moduli.begin(), moduli.end()};
  }
  Convergence iterate(NodalVector on_nodes, Displacement& displacement) override;
  [[nodiscard]] std::string accuracy_wanted() const override;

  /// The fields of an iteration.
  struct State {
    State(const NodeLattice& lattice, NodalField guess)
        : displacement(std::move(guess)), residual(lattice), direction(lattice), work(lattice) {}

    NodalField displacement, residual, direction, work;
    double energy = 0.0;   ///< twice the energy of the displacement found so far
    double largest = 0.0;  ///< largest component of the displacement when the residual was last computed from it
  };

  /// The outcome of a pass of conjugate gradients, which begins with the residual of the displacement.
  struct Pass {
    int iterations = 0;
    bool is_accurate = false;  ///< whether the residual of the recurrence is small enough
    double residual = 0.0;     ///< residual in the Euclidean norm
  };

  /// The displacement from which the iteration starts; frees the memory of its nodal values.
  [[nodiscard]] NodalField take_guess(Displacement& displacement) const;
  /// Sets the residual, the energy and the largest component to those of the displacement.
  void find_residual(Vec on_nodes, State& state);
  /// Iterates until the displacement is accurate.
  Pass iterate(State& state, int most_iterations);
  /// work = K direction
  void multiply(State& state);
  [[nodiscard]] bool is_accurate(double error, double energy) const noexcept;

  NodeLattice lattice_;
  LatticeBoundary boundary_;
  CellSweep sweep_;
  int threads_;
  double energy_tolerance_;
  LatticeSums sums_;
  std::unique_ptr<LatticePreconditioner> preconditioner_;
  CellModuli cells_;
  Moduli reference_{};  ///< moduli of the preconditioner [Pa]
};

}  // namespace breccia::quasistatic

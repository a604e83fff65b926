#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "breccia/quasistatic/quasistatic_problem.hpp"

#include "checkpoint/state.hpp"
#include "quasistatic/operator/elastic_operator.hpp"

namespace breccia::quasistatic {

/// Solves K w = f for the fluctuation w of the nodal displacements, for one set of moduli after the other, by
/// preconditioned conjugate gradients.
template <int dim>
class ElasticSolver {
 public:
  ElasticSolver(const ElasticSolver&) = delete;
  ElasticSolver& operator=(const ElasticSolver&) = delete;
  ElasticSolver(ElasticSolver&&) = delete;
  ElasticSolver& operator=(ElasticSolver&&) = delete;
  virtual ~ElasticSolver() = default;

  /// Takes new moduli [Pa], by material. The preconditioner of earlier moduli may be kept.
  void set_moduli(std::span<const Moduli> moduli);
  /// Makes the preconditioner for the present moduli.
  virtual void update_preconditioner() = 0;
  /// The displacement w with K w = forces, and the corresponding strains of phases, from an initial guess; the
  /// macroscopic part of the result is undefined. `least_energy`, if it is known, is a lower bound of twice the energy
  /// of the composite with w and the prescribed strain. It may be orders of magnitude below the energy of w alone, and
  /// w is then found as accurately as the energy of the composite needs. Throws NumericalError when the iteration does
  /// not converge.
  [[nodiscard]] Displacement solve(Forces forces, Displacement guess, std::optional<double> least_energy = {});

  /// Calls a function in every iteration of the solutions that follow; an exception that it throws, on all processes,
  /// ends the solution.
  void watch(std::function<void()> in_iteration) { in_iteration_ = std::move(in_iteration); }

  [[nodiscard]] const LinearEffort& effort() const noexcept { return effort_; }
  /// Continues the counts of the effort of an earlier run.
  void count_from(const LinearEffort& earlier) { effort_ = earlier; }

  /// Saves the moduli for which the preconditioner was made; saves nothing if the preconditioner is made anew for every
  /// set of moduli.
  virtual void save_preconditioner(StateWriter& /*state*/, const std::string& /*group*/) const {}
  /// Makes the preconditioner for these moduli again.
  virtual void restore_preconditioner(const StateReader& /*state*/, const std::string& /*group*/) {}

 protected:
  /// The outcome of an iteration.
  struct Convergence {
    bool is_converged;
    double residual;  ///< residual in the Euclidean norm
  };

  ElasticSolver(const ElasticOperator<dim>& elastic_operator, const LinearOptions& options, bool is_direct);

  [[nodiscard]] const ElasticOperator<dim>& elastic_operator() const noexcept { return *elastic_operator_; }
  /// The present moduli [Pa], by material.
  [[nodiscard]] const std::vector<Moduli>& moduli() const noexcept { return moduli_; }
  /// Whether a residual is small compared with the load, or as small as the rounding errors of the forces for
  /// displacements of up to `largest`.
  [[nodiscard]] bool is_small(double residual, double largest) const noexcept;
  /// Whether a residual is as small as the rounding errors of the forces for displacements of up to `largest`.
  [[nodiscard]] bool is_rounding(double residual, double largest) const noexcept;
  [[nodiscard]] std::optional<double> least_energy() const noexcept { return least_energy_; }
  /// To be called by each process in every iteration.
  void look_in_iteration() const {
    if (in_iteration_) in_iteration_();
  }
  void count_factorisation() { ++effort_.factorisations; }
  void count_iterations(int iterations);

 private:
  virtual void update_stiffness(std::span<const Moduli> moduli) = 0;
  /// Finds the fluctuation of a displacement for these nodal forces, whose memory may be freed.
  virtual Convergence iterate(NodalVector on_nodes, Displacement& displacement) = 0;
  /// The moduli of phases with which the solver computes: voids have a trace of stiffness (theory, section 10), unless
  /// the solver takes none.
  [[nodiscard]] virtual std::vector<Moduli> solvable(std::span<const Moduli> moduli) const;
  /// The accuracy at which an iteration ends: "a residual of 1.0e-10 of the load".
  [[nodiscard]] virtual std::string accuracy_wanted() const;

  const ElasticOperator<dim>* elastic_operator_;
  double tolerance_;
  std::vector<Moduli> moduli_;
  LinearEffort effort_;
  std::function<void()> in_iteration_;
  double prescribed_;  ///< size of the prescribed displacements: 1, of a unit strain, or 0 under a traction boundary
  double rounding_ = 0.0;               ///< norm of the rounding errors of the forces for displacements of order one
  double load_ = 0.0;                   ///< norm of the forces of the present solve
  std::optional<double> least_energy_;  ///< least energy of the present solve
};

/// The solver that the options request: direct, or iterative, by substructuring in 2 dimensions and by fast transforms
/// in 3, or by algebraic multigrid where a box is too small for its processes. In 3 dimensions boxes with gaps have a
/// solver of their own on one process, sparse factors on several.
template <int dim>
std::unique_ptr<ElasticSolver<dim>> make_elastic_solver(const ElasticOperator<dim>& elastic_operator,
                                                        const LinearOptions& options);

extern template class ElasticSolver<2>;
extern template class ElasticSolver<3>;

}  // namespace breccia::quasistatic

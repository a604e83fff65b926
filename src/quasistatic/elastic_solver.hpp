#pragma once

#include <memory>
#include <span>
#include <string>

#include "breccia/quasistatic/quasistatic_problem.hpp"

#include "elastic_box.hpp"

namespace breccia::quasistatic {

/// Solves K w = f for the displacements of the nodes, for one set of moduli after the other.
class ElasticSolver {
 public:
  ElasticSolver(const ElasticSolver&) = delete;
  ElasticSolver& operator=(const ElasticSolver&) = delete;
  ElasticSolver(ElasticSolver&&) = delete;
  ElasticSolver& operator=(ElasticSolver&&) = delete;
  virtual ~ElasticSolver() = default;

  /// Takes new moduli [Pa], by material. What was prepared for earlier moduli may remain the preconditioner.
  void set_moduli(std::span<const Moduli> moduli);
  /// Prepares for the present moduli.
  virtual void refresh() = 0;
  /// w such that K w = forces; on entry a guess. Leaves the share of the affine motion undefined.
  /// Throws NumericalError when the iteration does not converge.
  void solve(const Field& forces, Field& displacement);

  [[nodiscard]] const LinearEffort& effort() const noexcept { return effort_; }
  /// Counts on from an earlier run.
  void count_from(const LinearEffort& earlier) { effort_ = earlier; }

  /// What is left of earlier moduli in how the next are solved for, nothing where they are prepared for at once.
  virtual void save_preparation(StateWriter& /*state*/, const std::string& /*group*/) const {}
  /// Prepares in the same way again.
  virtual void restore_preparation(const StateReader& /*state*/, const std::string& /*group*/) {}

 protected:
  /// Where an iteration ended.
  struct End {
    bool is_converged;
    double residual;  ///< Euclidean norm
  };

  ElasticSolver(const ElasticBox& box, const LinearOptions& options, bool is_direct);

  [[nodiscard]] const ElasticBox& box() const noexcept { return *box_; }
  /// Whether a residual is small beside the load, or nothing but rounding of the forces for displacements up to
  /// `largest`.
  [[nodiscard]] bool is_small(double residual, double largest) const noexcept;
  void count_preparation() { ++effort_.factorisations; }
  void count_iterations(int iterations);

 private:
  virtual void take(std::span<const Moduli> moduli) = 0;
  virtual End iterate(const Field& forces, Field& displacement) = 0;

  const ElasticBox* box_;
  double tolerance_;
  LinearEffort effort_;
  double given_;           ///< size of the displacements that the boundary gives: of a unit strain, or none
  double rounding_ = 0.0;  ///< norm of the forces that displacements of order one leave by rounding alone
  double load_ = 0.0;      ///< norm of the forces of the present solve
};

/// Direct, by substructures, or by algebraic multigrid where there are several processes.
std::unique_ptr<ElasticSolver> make_elastic_solver(const ElasticBox& box, const LinearOptions& options);

}  // namespace breccia::quasistatic

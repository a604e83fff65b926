#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>

#include "quasistatic/solvers/elastic_solver.hpp"
#include "quasistatic/solvers/lattice/nodal_field.hpp"
#include "quasistatic/solvers/saddle_point/flow_factors.hpp"
#include "quasistatic/solvers/saddle_point/pressure_multigrid.hpp"
#include "quasistatic/solvers/saddle_point/saddle_point_operator.hpp"
#include "quasistatic/solvers/saddle_point/slope_elimination.hpp"
#include "quasistatic/solvers/saddle_point/two_level_preconditioner.hpp"
#include "quasistatic/solvers/saddle_point/weak_pressures.hpp"

namespace breccia::quasistatic {

/// MINRES (Paige and Saunders 1975) for periodic boxes of cubes with gaps on one process, as a saddle point with a
/// preconditioner for each block: two levels for the displacements, elimination of the slopes, sparse factors for
/// flows, multigrid for pressures, and a coarse space of pressures that nodes hardly resist. The number of iterations
/// hardly grows with the contrast of the moduli (docs/gaps-in-space.md).
class SaddlePointSolver final : public ElasticSolver<3> {
 public:
  /// Throws InputError for several processes and for boundaries that are not periodic.
  SaddlePointSolver(const ElasticOperator<3>& elastic_operator, const LinearOptions& options);

  /// Does nothing: the preconditioner follows the moduli.
  void update_preconditioner() override {}

 private:
  void update_stiffness(std::span<const Moduli> moduli) override;
  Convergence iterate(NodalVector on_nodes, Displacement& displacement) override;
  [[nodiscard]] std::string accuracy_wanted() const override;

  /// The forces, or the displacement, of a vector of nodal values; pressures are zero.
  [[nodiscard]] NodalField read(Vec nodal);
  void write(NodalField& field, Vec nodal);
  /// residual = right - K solution
  void find_residual(const NodalField& right, NodalField& solution, NodalField& residual);
  /// solution = P^-1 right
  void precondition(const NodalField& right, NodalField& solution);
  /// Sets the pressures to those of the displacement.
  void set_pressures(NodalField& solution);
  /// Whether the displacement of a solution with this residual is accurate, or as accurate as rounding allows.
  /// Preconditions the residual.
  [[nodiscard]] bool is_accurate(const NodalField& right, const NodalField& solution, const NodalField& residual);
  /// Iterates from a solution; returns the number of iterations, and whether the solution is accurate.
  std::pair<int, bool> iterate(const NodalField& right, NodalField& solution, int most_iterations);
  /// The Euclidean norm of the forces that remain when the pressures are eliminated.
  [[nodiscard]] double norm_of_forces(const NodalField& residual);

  SaddlePointOperator saddle_;
  double energy_tolerance_;
  LatticeSums sums_;
  std::optional<TwoLevelPreconditioner> of_displacements_;
  std::optional<SlopeElimination> of_slopes_;
  std::optional<FlowFactors> of_flows_;
  std::optional<PressureMultigrid> of_pressures_;
  std::optional<WeakPressures> of_weak_pressures_;
  NodalField condensed_, preconditioned_;
};

}  // namespace breccia::quasistatic

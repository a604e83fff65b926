#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "breccia/discretisation/point_fields.hpp"
#include "breccia/quasistatic/quasistatic_problem.hpp"

#include "quasistatic/operator/displacement_state.hpp"
#include "quasistatic/operator/elastic_operator.hpp"
#include "quasistatic/reduced/affine_composite.hpp"
#include "quasistatic/reduced/affine_stiffness.hpp"
#include "quasistatic/reduced/composite_state.hpp"
#include "quasistatic/reduced/condensed_vectors.hpp"
#include "quasistatic/solvers/elastic_solver.hpp"

namespace breccia::quasistatic {

/// A composite of cells in the form for a reduced basis (AffineComposite): the elastic operator of a discretisation,
/// with a part for each modulus of the phases that vary.
template <int dim>
class CellComposite {
 public:
  using Vector = Displacement;
  /// The type that stores the vectors. Cubes have many mixed cells, so that memory is short; for squares it is not.
  using BasisVectors = std::conditional_t<dim == 3, CondensedVectors, StoredVectors<Displacement>>;
  static constexpr std::size_t forces_at_hand = dim == 3 ? 1 : 64;

  CellComposite(const QuasistaticProblem<dim>& problem, std::span<const VaryingPhase> varying);

  [[nodiscard]] const ElasticOperator<dim>& elastic_operator() const noexcept { return elastic_operator_; }
  [[nodiscard]] const AffineStiffness& stiffness() const noexcept { return stiffness_; }

  [[nodiscard]] Boundary boundary() const noexcept { return elastic_operator_.boundary(); }
  [[nodiscard]] double volume() const noexcept { return elastic_operator_.volume(); }
  [[nodiscard]] std::vector<PhaseModulus> parameters() const;
  [[nodiscard]] BasisVectors no_vectors(Load load) const;
  [[nodiscard]] Displacement zero() const { return elastic_operator_.zero(); }
  [[nodiscard]] Displacement uniform_strain(Load load) const { return elastic_operator_.uniform_strain(load); }
  [[nodiscard]] Forces load_forces(Load load) const { return elastic_operator_.load_forces(load); }
  [[nodiscard]] Forces constant_forces(Load load, const Displacement& displacement) const;
  [[nodiscard]] Forces part_forces(std::size_t part, Load load, const Displacement& displacement) const;
  [[nodiscard]] Forces forces(std::span<const double> parameters, Load load, const Displacement& displacement) const;
  [[nodiscard]] Forces varying_forces(std::span<const double> parameters, Load load,
                                      const Displacement& displacement) const;

 private:
  AffineStiffness stiffness_;
  ElasticOperator<dim> elastic_operator_;
};

/// Fields of the material points of a square, or of the cells of a cube, in a state under a load (theory, Eq. 35).
/// `problem` is the problem from which the composite was made. The fields are those of the cells of this process.
template <int dim>
[[nodiscard]] LatticeFields<dim> fields_of(const CellComposite<dim>& composite, const QuasistaticProblem<dim>& problem,
                                           Load load, const CompositeState<Displacement>& state);

/// Solves for the displacements of a composite of cells, which must outlive it.
template <int dim>
class CellSolver {
 public:
  CellSolver(const CellComposite<dim>& composite, const LinearOptions& options);

  void prepare(std::span<const double> parameters);
  [[nodiscard]] Displacement solve(Load load, Displacement guess);

  /// Takes new moduli, and keeps the preconditioner of earlier ones as long as it is good enough.
  void take(std::span<const double> parameters);
  [[nodiscard]] Displacement solve_forces(Load load, const Forces& forces, Displacement guess);
  void save_preconditioner(StateWriter& state, const std::string& group) const;
  void restore_preconditioner(const StateReader& state, const std::string& group);

  /// Calls a function in every iteration (ElasticSolver::watch).
  void watch(std::function<void()> in_iteration) { solver_->watch(std::move(in_iteration)); }
  [[nodiscard]] const LinearEffort& effort() const noexcept { return solver_->effort(); }
  void count_from(const LinearEffort& earlier) { solver_->count_from(earlier); }

 private:
  [[nodiscard]] Forces held_back(Load load) const;
  [[nodiscard]] std::optional<double> least_energy(Load load) const;
  void require_solid_sides() const;
  void require_stiffness(Load load, const Displacement& solution) const;

  const CellComposite<dim>* composite_;
  std::unique_ptr<ElasticSolver<dim>> solver_;
  std::vector<Moduli> moduli_;  ///< moduli by material
};

extern template class CellComposite<2>;
extern template class CellComposite<3>;
extern template class CellSolver<2>;
extern template class CellSolver<3>;

}  // namespace breccia::quasistatic

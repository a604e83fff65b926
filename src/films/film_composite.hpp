#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>

#include "films/assembly/film_operator.hpp"
#include "films/solver/full_factors_limit.hpp"
#include "films/solver/symmetric_solver.hpp"
#include "quasistatic/reduced/affine_composite.hpp"
#include "quasistatic/reduced/stored_vectors.hpp"

namespace breccia::films {

/// Grains and films as an affine composite for a reduced basis, with the shear and the bulk modulus of the binder as
/// parameters.
template <int dim>
class FilmComposite {
 public:
  using Vector = FilmVector;
  using BasisVectors = quasistatic::StoredVectors<FilmVector>;
  static constexpr std::size_t forces_at_hand = 3;   ///< number of parts whose forces are held in memory: all
  static constexpr std::size_t shear = 0, bulk = 1;  ///< indices of the moduli of the binder among the parameters

  explicit FilmComposite(const FilmProblem<dim>& problem) : film_operator_(problem) {}

  [[nodiscard]] const FilmOperator<dim>& film_operator() const noexcept { return film_operator_; }

  [[nodiscard]] Boundary boundary() const noexcept { return film_operator_.boundary(); }
  /// Lengths are in sides of the box.
  [[nodiscard]] static constexpr double volume() noexcept { return 1.0; }
  [[nodiscard]] static std::array<PhaseModulus, 2> parameters();
  [[nodiscard]] static BasisVectors no_vectors(Load /*load*/) { return {}; }
  [[nodiscard]] FilmVector zero() const { return film_operator_.zero(); }
  [[nodiscard]] FilmVector uniform_strain(Load load) const { return film_operator_.uniform_strain(load); }
  [[nodiscard]] FilmVector load_forces(Load load) const { return film_operator_.load_forces(load); }
  [[nodiscard]] FilmVector constant_forces(Load load, const FilmVector& displacement) const {
    return film_operator_.grain_forces(load, displacement);
  }
  [[nodiscard]] FilmVector part_forces(std::size_t part, Load load, const FilmVector& displacement) const;
  [[nodiscard]] FilmVector forces(std::span<const double> parameters, Load load, const FilmVector& displacement) const;
  [[nodiscard]] FilmVector varying_forces(std::span<const double> parameters, Load load,
                                          const FilmVector& displacement) const;

 private:
  FilmOperator<dim> film_operator_;
};

/// Solves for the displacements of grains and films, which must outlive it, for one binder after the other.
template <int dim>
class FilmSolver {
 public:
  /// In space, more unknowns than `most_of_full_factors` are solved for by CompressedFactors.
  explicit FilmSolver(const FilmComposite<dim>& composite, std::int64_t most_of_full_factors = full_factors_in_space);

  /// Factorises the matrix for a binder with these positive moduli [Pa], shear and bulk.
  void prepare(std::span<const double> parameters);
  /// The displacement under the unit strain of a load or, under a traction boundary, its unit stress. The guess is not
  /// used.
  [[nodiscard]] FilmVector solve(Load load, const FilmVector& guess);

  /// Calls prepare(), since each binder needs factors of its own.
  void take(std::span<const double> parameters) { prepare(parameters); }
  /// The fluctuations and flows for these forces on them, in a time step under a load. The guess is not used.
  [[nodiscard]] FilmVector solve_forces(Load load, const FilmVector& forces, const FilmVector& guess);
  /// Modulus [Pa] from the energy of a solution for the present binder.
  [[nodiscard]] double modulus(Load load, const FilmVector& solution) const;

  /// Calls a function in every iteration of the solutions that follow, as SymmetricSolver does.
  void watch(std::function<void()> in_iteration) { solver_->watch(std::move(in_iteration)); }

  [[nodiscard]] const LinearEffort& effort() const noexcept { return effort_; }
  void count_from(const LinearEffort& earlier) { effort_ = earlier; }

 private:
  const FilmComposite<dim>* composite_;
  std::array<double, 2> parameters_{};
  std::unique_ptr<SymmetricSolver> solver_;
  LinearEffort effort_;
};

}  // namespace breccia::films

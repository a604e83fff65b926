#pragma once

#include "breccia/discretisation/load.hpp"
#include "breccia/quasistatic/quasistatic_problem.hpp"

#include "assembly/film_operator.hpp"
#include "solver/symmetric_factors.hpp"

namespace breccia::films {

/// Displacements of grains and films under a load, for one binder after the other.
class FilmSolver {
 public:
  explicit FilmSolver(const FilmOperator& film_operator) : film_operator_(&film_operator) {
    effort_.unknowns = film_operator.unknowns() + film_operator.pressures();
  }

  /// Takes a binder of these moduli [Pa], which are positive.
  void set_binder(const Moduli& binder);
  /// The solution under the unit strain of a load or, under a traction boundary, its unit stress.
  [[nodiscard]] FilmVector solve(Load load);
  /// Modulus [Pa] from the energy of a solution at the present moduli of the binder.
  [[nodiscard]] double modulus(Load load, const FilmVector& solution) const;

  [[nodiscard]] const LinearEffort& effort() const noexcept { return effort_; }
  /// Entries of the factors of the present binder.
  [[nodiscard]] double entries() const { return factors_.entries(); }

 private:
  [[nodiscard]] FilmVector forces(Load load, const FilmVector& displacement) const;

  const FilmOperator* film_operator_;
  Moduli binder_{};
  SymmetricFactors factors_;
  LinearEffort effort_;
};

}  // namespace breccia::films

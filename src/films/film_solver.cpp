#include "film_solver.hpp"

#include <algorithm>

namespace breccia::films {

void FilmSolver::set_binder(const Moduli& binder) {
  binder_ = binder;
  factors_.factorise(film_operator_->matrix(binder));
  ++effort_.factorisations;
}

FilmVector FilmSolver::forces(Load load, const FilmVector& displacement) const {
  auto sum = film_operator_->grain_forces(load, displacement);
  sum.add(binder_.shear, film_operator_->shear_forces(load, displacement));
  sum.add(binder_.bulk, film_operator_->bulk_forces(load, displacement));
  return sum;
}

FilmVector FilmSolver::solve(Load load) {
  const bool is_strained = film_operator_->boundary() != Boundary::traction;
  auto solution = film_operator_->zero();
  Eigen::VectorXd right_side = Eigen::VectorXd::Zero(film_operator_->unknowns() + film_operator_->pressures());
  if (is_strained) {
    // The pressures that the prescribed strain has are eliminated from its forces: they need no right side.
    solution.macroscopic = 1.0;
    right_side.head(film_operator_->unknowns()) = -forces(load, solution).unknowns;
  } else {
    right_side.head(film_operator_->unknowns()) = film_operator_->load_forces(load).unknowns;
  }
  solution.unknowns = factors_.solve(right_side).head(film_operator_->unknowns());
  ++effort_.solves;
  effort_.largest_residual = std::max(effort_.largest_residual, factors_.residual());
  return solution;
}

double FilmSolver::modulus(Load load, const FilmVector& solution) const {
  const double energy = work(forces(load, solution), solution);
  return film_operator_->boundary() == Boundary::traction ? 1.0 / energy : energy;
}

}  // namespace breccia::films

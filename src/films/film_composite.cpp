#include "films/film_composite.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "films/solver/compressed_factors.hpp"
#include "films/solver/symmetric_factors.hpp"
#include "quasistatic/stepping/log_time_integrator.hpp"

namespace breccia::films {

static_assert(quasistatic::AffineComposite<FilmComposite<2>>);
static_assert(quasistatic::CompositeSolver<FilmSolver<2>, FilmVector>);
static_assert(quasistatic::SteppableComposite<FilmComposite<2>>);
static_assert(quasistatic::StepSolver<FilmSolver<2>, FilmVector>);

template <int dim>
std::array<PhaseModulus, 2> FilmComposite<dim>::parameters() {
  const std::string phase(name_of_matrix_phase);
  return {{{phase, ElasticModulus::shear}, {phase, ElasticModulus::bulk}}};
}

template <int dim>
FilmVector FilmComposite<dim>::part_forces(std::size_t part, Load load, const FilmVector& displacement) const {
  return part == shear ? film_operator_.shear_forces(load, displacement)
                       : film_operator_.bulk_forces(load, displacement);
}

template <int dim>
FilmVector FilmComposite<dim>::varying_forces(std::span<const double> parameters, Load load,
                                              const FilmVector& displacement) const {
  auto sum = zero();
  for (std::size_t part = 0; part < parameters.size(); ++part) {
    sum.add(parameters[part], part_forces(part, load, displacement));
  }
  return sum;
}

template <int dim>
FilmVector FilmComposite<dim>::forces(std::span<const double> parameters, Load load,
                                      const FilmVector& displacement) const {
  auto sum = constant_forces(load, displacement);
  for (std::size_t part = 0; part < parameters.size(); ++part) {
    sum.add(parameters[part], part_forces(part, load, displacement));
  }
  return sum;
}

namespace {

/// The largest memory of full factors in a process [B]. It does not depend on the free memory, because factors in files
/// change the last digits.
constexpr double memory_of_factors = 2e9;

}  // namespace

template <int dim>
FilmSolver<dim>::FilmSolver(const FilmComposite<dim>& composite, std::int64_t most_of_full_factors)
    : composite_(&composite) {
  effort_.unknowns = composite.film_operator().unknowns() + composite.film_operator().pressures();
  // In the plane compressed factors have most of the entries of full ones.
  effort_.is_direct = dim == 2 || effort_.unknowns <= most_of_full_factors;
  if (effort_.is_direct) {
    solver_ = std::make_unique<SymmetricFactors>(memory_of_factors);
  } else {
    solver_ = std::make_unique<CompressedFactors>(memory_of_factors);
  }
}

template <int dim>
void FilmSolver<dim>::prepare(std::span<const double> parameters) {
  std::ranges::copy(parameters, parameters_.begin());
  solver_->factorise(
      [this] { return composite_->film_operator().matrix({.bulk = parameters_[1], .shear = parameters_[0]}); });
  ++effort_.factorisations;
}

template <int dim>
FilmVector FilmSolver<dim>::solve_forces(Load /*load*/, const FilmVector& forces, const FilmVector& /*guess*/) {
  const auto& film_operator = composite_->film_operator();
  Eigen::VectorXd right_side = Eigen::VectorXd::Zero(film_operator.unknowns() + film_operator.pressures());
  right_side.head(film_operator.unknowns()) = forces.unknowns();
  auto solution = composite_->zero();
  solution.set_unknowns(solver_->solve(right_side).head(film_operator.unknowns()));
  ++effort_.solves;
  const auto& [factorisations, iterations, residual] = solver_->effort();
  effort_.factorisations += factorisations;
  effort_.iterations += iterations;
  effort_.most_iterations = std::max(effort_.most_iterations, iterations);
  effort_.largest_residual = std::max(effort_.largest_residual, residual);
  return solution;
}

template <int dim>
FilmVector FilmSolver<dim>::solve(Load load, const FilmVector& guess) {
  if (composite_->boundary() == Boundary::traction) return solve_forces(load, composite_->load_forces(load), guess);
  // The forces of the uniform strain include those of its pressures, so that the solution has only the remaining
  // pressures.
  auto prescribed = composite_->zero();
  prescribed.set_macroscopic(1.0);
  auto forces = composite_->forces(parameters_, load, prescribed);
  forces.scale(-1.0);
  auto solution = solve_forces(load, forces, guess);
  solution.set_macroscopic(1.0);
  return solution;
}

template <int dim>
double FilmSolver<dim>::modulus(Load load, const FilmVector& solution) const {
  const double energy = work(composite_->forces(parameters_, load, solution), solution);
  return composite_->boundary() == Boundary::traction ? 1.0 / energy : energy;
}

template class FilmComposite<2>;
template class FilmComposite<3>;
template class FilmSolver<2>;
template class FilmSolver<3>;

}  // namespace breccia::films

#include "quasistatic/solvers/lattice/lattice_solver.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/contrast.hpp"
#include "parallel/reduction.hpp"
#include "quasistatic/operator/cube_forces.hpp"

namespace breccia::quasistatic {

LatticeSolver::LatticeSolver(const ElasticOperator<3>& elastic_operator, const LinearOptions& options)
    : ElasticSolver(elastic_operator, options, false),
      lattice_(elastic_operator.nodes()),
      boundary_(lattice_),
      sweep_(lattice_.own_cells(), lattice_.arrays),
      threads_(elastic_operator.threads()),
      energy_tolerance_(options.energy_tolerance),
      sums_(3 * lattice_.size(), threads_),
      preconditioner_(make_lattice_preconditioner(lattice_, threads_)) {}

void LatticeSolver::update_stiffness(std::span<const Moduli> moduli) {
  // The box of one material has the least moduli of all solid phases, so that without voids no displacement has less
  // energy in the composite than in this box. The estimate of the error is then a bound, except under a traction
  // boundary (theory, section 18).
  reference_ = least_of_solids(moduli);
  if (!(reference_.shear > 0.0) || !(reference_.bulk > 0.0)) {
    throw NumericalError(
        "quasi-static solver: a modulus of a phase is zero or negative, which the iterative method in 3 dimensions "
        "does not take; a small one may serve");
  }
  cells_ = condensed_cells(elastic_operator(), moduli);
  count_factorisation();
}

void LatticeSolver::multiply(State& state) {
  boundary_.repeat_first_nodes(state.direction);
  sums_.set_zero(state.work);
  sweep_.add_forces(cells_, static_cast<const NodalField&>(state.direction).components(), state.work.components(),
                    threads_);
  boundary_.collect(state.work);
}

bool LatticeSolver::is_accurate(double error, double energy) const noexcept {
  // In a soft matrix the fluctuation nearly cancels the prescribed strain: its own energy is orders of magnitude above
  // that of the composite. The error must be small relative to both.
  constexpr double of_composite = 1e-8;
  return error <= energy_tolerance_ * energy_tolerance_ * energy &&
         (!least_energy() || error <= of_composite * *least_energy());
}

std::string LatticeSolver::accuracy_wanted() const {
  return fmt::format("an error of {:.1e} of the fluctuation, in the energy norm", energy_tolerance_);
}

LatticeSolver::Pass LatticeSolver::iterate(State& state, int most_iterations) {
  auto& [displacement, residual, direction, work, energy, largest] = state;
  sums_.set_zero(direction);
  double before = 1.0, norm = std::sqrt(sums_.product(residual, residual));
  int iterations = 0;
  // A residual that is small compared with the load may still belong to a large error of the displacement of a soft
  // matrix, so that only the energy, or rounding, ends the iteration.
  for (; !is_rounding(norm, state.largest); ++iterations) {
    look_in_iteration();
    preconditioner_->apply(reference_, residual, work);
    const double now = sums_.product(residual, work);
    if (is_accurate(now, energy)) break;
    if (!(iterations < most_iterations)) return {iterations, false, norm};
    sums_.combine(now / before, direction, work);
    multiply(state);
    const double curvature = sums_.product(direction, work);
    if (!(curvature > 0.0)) {
      throw NumericalError(fmt::format(
          "quasi-static solver: a displacement has the energy {:.1e}, so the stiffness is not positive definite; "
          "a modulus of a material may vanish or be negative, or the contrast be beyond what numbers hold",
          curvature));
    }
    const double step = now / curvature;
    sums_.add(displacement, step, direction);
    sums_.add(residual, -step, work);
    energy += step * now;
    before = now;
    norm = std::sqrt(sums_.product(residual, residual));
  }
  return {iterations, std::isfinite(norm), norm};
}

void LatticeSolver::find_residual(Vec on_nodes, State& state) {
  auto& [displacement, residual, direction, work, energy, largest] = state;
  const auto [least, most] = std::ranges::minmax(displacement.all());
  largest = parallel::largest(std::max(-least, most));
  boundary_.read(on_nodes, residual);
  boundary_.balance(residual);
  energy = sums_.product(displacement, residual);
  std::ranges::copy(displacement.all(), direction.all().begin());
  multiply(state);
  sums_.add(residual, -1.0, work);
  energy += sums_.product(displacement, residual);
}

NodalField LatticeSolver::take_guess(Displacement& displacement) const {
  const auto nodal = displacement.take_fluctuation();
  NodalField guess(lattice_);
  boundary_.read(nodal.get(), guess);
  return guess;
}

ElasticSolver<3>::Convergence LatticeSolver::iterate(NodalVector on_nodes, Displacement& displacement) {
  constexpr int most_iterations = 20'000, most_passes = 10;
  State state(lattice_, take_guess(displacement));
  // Within a pass the residual is updated by recurrence, and rounding makes it drift away from the residual of the
  // displacement. The next pass begins with the latter; a pass without iterations is the last one.
  Pass pass;
  int iterations = 0;
  for (int passes = 0; passes < most_passes; ++passes) {
    find_residual(on_nodes.get(), state);
    pass = iterate(state, most_iterations - iterations);
    iterations += pass.iterations;
    if (pass.iterations == 0 || !pass.is_accurate) break;
  }
  count_iterations(iterations);
  boundary_.settle(state.displacement);
  boundary_.write(state.displacement, on_nodes.get());
  displacement.set_fluctuation(std::move(on_nodes));
  return {pass.is_accurate && pass.iterations == 0, pass.residual};
}

}  // namespace breccia::quasistatic

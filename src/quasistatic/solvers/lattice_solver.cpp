#include "solvers/lattice_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia::quasistatic {

LatticeSolver::LatticeSolver(const ElasticOperator<3>& elastic_operator, const LinearOptions& options)
    : ElasticSolver(elastic_operator, options, false),
      lattice_(elastic_operator.grid().cells, elastic_operator.boundary()),
      boundary_(lattice_),
      sweep_(lattice_.cells, lattice_.arrays),
      threads_(elastic_operator.threads()),
      energy_tolerance_(options.energy_tolerance),
      sums_(3 * lattice_.places(), threads_),
      preconditioner_(make_lattice_preconditioner(lattice_, threads_)) {}

void LatticeSolver::update_stiffness(std::span<const Moduli> moduli) {
  // With the least moduli of all phases, no displacement of the composite has less energy than in the box of one
  // material, which makes the estimate of the error a bound, but for a traction boundary (theory, section 18).
  constexpr double largest = std::numeric_limits<double>::infinity();
  reference_ = {.bulk = largest, .shear = largest};
  for (const auto& [bulk, shear] : moduli) {
    reference_ = {.bulk = std::min(reference_.bulk, bulk), .shear = std::min(reference_.shear, shear)};
  }
  if (!(reference_.shear > 0.0) || !(reference_.bulk > 0.0)) {
    throw NumericalError(
        "quasi-static solver: a modulus of a phase is zero or negative, which the iterative method in 3 dimensions "
        "does "
        "not take; a small one may serve");
  }
  cells_ = elastic_operator().condensed_cells(moduli);
  count_factorisation();
}

void LatticeSolver::multiply(State& state) const {
  boundary_.repeat_first_nodes(state.direction);
  sums_.set_zero(state.work);
  sweep_.add_forces(cells_, static_cast<const LatticeField&>(state.direction).components(), state.work.components(),
                    threads_);
  boundary_.collect(state.work);
}

bool LatticeSolver::is_accurate(double error, double energy) const noexcept {
  // Beside a soft matrix the fluctuation all but cancels the strain that is prescribed, so that its own energy is far
  // greater than that of the composite, which must be right, too.
  constexpr double of_composite = 1e-8;
  return error <= energy_tolerance_ * energy_tolerance_ * energy &&
         (!least_energy() || error <= of_composite * *least_energy());
}

double LatticeSolver::iterate(State& state, int most_iterations) {
  auto& [displacement, residual, direction, work, energy] = state;
  sums_.set_zero(direction);
  double before = 1.0, norm = std::sqrt(sums_.product(residual, residual));
  int iterations = 0;
  for (; !is_small(norm, 0.0) && iterations < most_iterations; ++iterations) {
    preconditioner_->apply(reference_, residual, work);
    const double now = sums_.product(residual, work);
    if (is_accurate(now, energy)) break;
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
  count_iterations(iterations);
  return norm;
}

ElasticSolver<3>::End LatticeSolver::iterate(NodalVector on_nodes, Displacement& displacement) {
  constexpr int most_iterations = 20'000;
  State state(lattice_);
  boundary_.read(on_nodes.get(), state.residual);
  on_nodes = {};
  {
    const auto guess = displacement.take_fluctuation();
    boundary_.read(guess.get(), state.displacement);
    boundary_.read(guess.get(), state.direction);
  }
  boundary_.balance(state.residual);
  state.energy = sums_.product(state.displacement, state.residual);
  multiply(state);
  sums_.add(state.residual, -1.0, state.work);
  state.energy += sums_.product(state.displacement, state.residual);
  const int earlier = effort().iterations;
  const double norm = iterate(state, most_iterations);
  boundary_.settle(state.displacement);
  displacement.set_fluctuation(elastic_operator().nodes().zeros());
  boundary_.write(state.displacement, displacement.fluctuation());
  return {effort().iterations - earlier < most_iterations && std::isfinite(norm), norm};
}

}  // namespace breccia::quasistatic

#include "quasistatic/solvers/saddle_point/saddle_point_solver.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia::quasistatic {

SaddlePointSolver::SaddlePointSolver(const ElasticOperator<3>& elastic_operator, const LinearOptions& options)
    : ElasticSolver(elastic_operator, options, false),
      saddle_(elastic_operator),
      energy_tolerance_(options.energy_tolerance),
      sums_(saddle_.size(), saddle_.threads()),
      condensed_(saddle_.zeros()),
      preconditioned_(saddle_.zeros()) {}

void SaddlePointSolver::update_stiffness(std::span<const Moduli> moduli) {
  for (const auto& [bulk, shear] : moduli) {
    if (bulk > 0.0 && shear > 0.0) continue;
    throw NumericalError(
        "quasi-static solver: a modulus of a phase is zero or negative, which the iterative method in 3 dimensions "
        "does not take; a small one may serve");
  }
  saddle_.set_moduli(moduli);
  of_displacements_.emplace(saddle_);
  of_slopes_.emplace(saddle_);
  of_flows_.emplace(saddle_);
  of_pressures_.emplace(saddle_);
  of_weak_pressures_.emplace(saddle_);
  count_factorisation();
}

NodalField SaddlePointSolver::read(Vec nodal) {
  auto field = saddle_.zeros();
  saddle_.boundary().read(nodal, field);
  std::ranges::copy(saddle_.layout().values(nodal), saddle_.gaps(field).begin());
  return field;
}

void SaddlePointSolver::write(NodalField& field, Vec nodal) {
  saddle_.boundary().settle(field);
  saddle_.boundary().write(field, nodal);
  saddle_.layout().set(saddle_.gaps(field), nodal);
}

void SaddlePointSolver::find_residual(const NodalField& right, NodalField& solution, NodalField& residual) {
  saddle_.multiply(solution, residual);
  sums_.combine(-1.0, residual, right);
}

void SaddlePointSolver::precondition(const NodalField& right, NodalField& solution) {
  of_slopes_->condense(right, condensed_);
  saddle_.boundary().collect(condensed_);
  of_displacements_->apply(condensed_, solution);
  saddle_.boundary().repeat_first_nodes(solution);
  of_slopes_->recover(right, solution);
  of_flows_->apply(right, solution);
  of_pressures_->apply(right, solution);
  of_weak_pressures_->add_to(right, solution);
}

void SaddlePointSolver::set_pressures(NodalField& solution) {
  auto product = saddle_.zeros();
  std::ranges::fill(saddle_.pressures(solution), 0.0);
  saddle_.multiply(solution, product);
  for (std::size_t cell = 0; cell < saddle_.cells(); ++cell) {
    saddle_.pressures(solution)[cell] =
        saddle_.bulk_of_pressures()[saddle_.kinds()[cell]] * saddle_.pressures(product)[cell];
  }
}

/// With a residual (r, s), k s^2 + r' A^-1 r is twice the distance of the energy of w from the least value of the
/// Lagrangian at p, a lower bound of the least energy, and so a bound of twice the energy of the error of w.
bool SaddlePointSolver::is_accurate(const NodalField& right, const NodalField& solution, const NodalField& residual) {
  // Of the preconditioned A, 0.2 is the least eigenvalue that boxes with particles of eight cells and more have shown.
  constexpr double of_preconditioner = 10.0, of_composite = 1e-8;
  precondition(residual, preconditioned_);
  double of_pressures = 0.0, error = 0.0;
  const auto left = saddle_.pressures(residual);
  const auto found = saddle_.pressures(std::as_const(preconditioned_));
  for (std::size_t cell = 0; cell < left.size(); ++cell) {
    of_pressures += left[cell] * found[cell];
    error += saddle_.bulk_of_pressures()[saddle_.kinds()[cell]] * left[cell] * left[cell];
  }
  error += of_preconditioner * (sums_.product(residual, preconditioned_) - of_pressures);
  const double energy = sums_.product(solution, right);
  const double most = least_energy() ? of_composite * *least_energy() : energy_tolerance_ * energy_tolerance_ * energy;
  if (error <= most) return true;
  const auto [least, largest] = std::ranges::minmax(solution.all().first(saddle_.first_pressure()));
  return is_rounding(norm_of_forces(residual), std::max(-least, largest));
}

std::string SaddlePointSolver::accuracy_wanted() const {
  return least_energy() ? "an error of 1e-8 of the energy of a box of the softest phase"
                        : fmt::format("an error of {:.1e} of the fluctuation, in the energy norm", energy_tolerance_);
}

std::pair<int, bool> SaddlePointSolver::iterate(const NodalField& right, NodalField& solution, int most_iterations) {
  // The notation is that of Elman, Silvester and Wathen 2014, algorithm 4.1.
  constexpr int between_checks = 20;
  constexpr double rounding = 1e-15;
  auto residual = saddle_.zeros(), before = saddle_.zeros(), next = saddle_.zeros();
  auto z = saddle_.zeros(), w = saddle_.zeros(), w_before = saddle_.zeros();
  find_residual(right, solution, residual);
  if (is_accurate(right, solution, residual)) return {0, true};
  std::swap(z, preconditioned_);
  double gamma = std::sqrt(sums_.product(residual, z)), gamma_before = 1.0;
  if (!(gamma > 0.0)) return {0, false};
  const double first = gamma;
  double eta = gamma, s = 0.0, s_before = 0.0, c = 1.0, c_before = 1.0;
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    look_in_iteration();
    sums_.scale(z, 1.0 / gamma);
    saddle_.multiply(z, next);
    const double delta = sums_.product(z, next);
    // The next vector of Lanczos: next = K z - (delta / gamma) residual - (gamma / gamma_before) before.
    sums_.add(next, -delta / gamma, residual);
    sums_.add(next, -gamma / gamma_before, before);
    std::swap(before, residual);
    std::swap(residual, next);
    // The rotations that triangulate the matrix of Lanczos.
    const double alpha_2 = s * delta + c_before * c * gamma, alpha_3 = s_before * gamma;
    std::swap(w, w_before);
    // w = (z - alpha_3 w of two steps before - alpha_2 w of the step before) / alpha_1
    precondition(residual, preconditioned_);
    const double square = sums_.product(residual, preconditioned_);
    if (!(square >= 0.0)) {
      throw NumericalError(
          "quasi-static solver: the preconditioner is not positive definite; a modulus of a material may vanish or be "
          "negative, or the contrast be beyond what numbers hold");
    }
    const double gamma_next = std::sqrt(square);
    const double alpha_0 = c * delta - c_before * s * gamma;
    const double alpha_1 = std::hypot(alpha_0, gamma_next);
    sums_.scale(w, -alpha_3 / alpha_1);
    sums_.add(w, 1.0 / alpha_1, z);
    sums_.add(w, -alpha_2 / alpha_1, w_before);
    c_before = std::exchange(c, alpha_0 / alpha_1);
    s_before = std::exchange(s, gamma_next / alpha_1);
    sums_.add(solution, c * eta, w);
    eta *= -s;
    std::swap(z, preconditioned_);
    gamma_before = std::exchange(gamma, gamma_next);
    const bool is_spent = !(std::abs(eta) > rounding * first) || gamma == 0.0;
    if (iteration % between_checks != 0 && !is_spent) continue;
    find_residual(right, solution, next);
    if (is_accurate(right, solution, next)) return {iteration, true};
    if (is_spent) return {iteration, false};
  }
  return {most_iterations, false};
}

double SaddlePointSolver::norm_of_forces(const NodalField& residual) {
  auto forces = saddle_.zeros(), product = saddle_.zeros();
  for (std::size_t cell = 0; cell < saddle_.cells(); ++cell) {
    saddle_.pressures(forces)[cell] =
        saddle_.bulk_of_pressures()[saddle_.kinds()[cell]] * saddle_.pressures(residual)[cell];
  }
  saddle_.multiply(forces, product);
  sums_.add(product, 1.0, residual);
  std::ranges::fill(saddle_.pressures(product), 0.0);
  return std::sqrt(sums_.product(product, product));
}

ElasticSolver<3>::Convergence SaddlePointSolver::iterate(NodalVector on_nodes, Displacement& displacement) {
  constexpr int most_iterations = 5'000, most_passes = 5;
  auto right = read(on_nodes.get());
  saddle_.boundary().balance(right);
  auto solution = read(displacement.take_fluctuation().get());
  set_pressures(solution);
  int iterations = 0;
  bool is_done = false;
  // A pass ends early when rounding has spent its recurrence; the next one begins with the residual.
  for (int pass = 0; pass < most_passes && !is_done && iterations < most_iterations; ++pass) {
    const auto [of_pass, is_accurate_now] = iterate(right, solution, most_iterations - iterations);
    iterations += of_pass;
    is_done = is_accurate_now;
  }
  count_iterations(iterations);
  auto residual = saddle_.zeros();
  find_residual(right, solution, residual);
  const double norm = norm_of_forces(residual);
  write(solution, on_nodes.get());
  displacement.set_fluctuation(std::move(on_nodes));
  return {is_done, norm};
}

}  // namespace breccia::quasistatic

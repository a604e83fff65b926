// Example 8: a material law of your own. The binder relaxes by a power law, which is sampled and fitted to a Prony
// series. The composite that follows is compared with an elastic one by the correspondence principle: at a real Laplace
// variable s, the Carson transform s G~(s) of its modulus is the modulus of the elastic composite whose binder has the
// Carson transforms of the binder's moduli. That composite is computed without any Prony series.

#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "breccia/homogenisation/solve.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/quasistatic/apparent_moduli.hpp"
#include "breccia/viscoelasticity/fit.hpp"

using namespace breccia;

namespace {

/// The law: from 100 MPa down to 1 MPa by the power -0.4 of time. Shear modulus [Pa] at a time [s].
double power_law(double time) {
  return 1e6 + 99e6 * std::pow(1.0 + time / 1e-3, -0.4);
}

/// Carson transform of the law [Pa], s times the integral of G(t) exp(-s t), by the trapezoidal rule in ln t.
double carson_of_law(double s) {
  constexpr double step = 0.01;
  double sum = 0.0;
  for (double logarithm = -40.0; logarithm < 5.0; logarithm += step) {
    const double st = std::exp(logarithm);  // s t
    sum += power_law(st / s) * std::exp(-st) * st * step;
  }
  return sum;
}

/// Carson transform of a Prony series [Pa].
double carson_of_series(const PronySeries& series, double s) {
  double sum = series.equilibrium();
  for (const auto& [time, modulus] : series.terms()) sum += modulus * s * time / (1.0 + s * time);
  return sum;
}

}  // namespace

int main() {
  std::vector<double> times, moduli;
  for (double time = 1e-6; time < 1e6; time *= 1.25) {
    times.push_back(time);
    moduli.push_back(power_law(time));
  }
  // Two relaxation times a decade are enough for a law as smooth as this.
  const auto fit = fit_relaxation(times, moduli, {.times_per_decade = 2.0});
  fmt::print("The power law as a Prony series: {} terms, within {:.2f} %\n", fit.series.terms().size(),
             100.0 * fit.quality.worst_error);

  const Material binder = {"binder", 1000.0, PronySeries(2e9), fit.series};
  const Material grain = {"grain", 2000.0, PronySeries(20e9), PronySeries(10e9)};
  const Filler filler = {.material = grain, .fraction = 0.25, .sizes = SingleSize{1.1e-3}, .gap = 0.25e-3};
  const Stage box = {.name = "box", .matrix = binder, .side = 8e-3, .cells = 64, .fillers = {filler}};
  const Study study = {.stages = {box},
                       .tests = {.boundaries = {Boundary::displacement}, .first_time = 1e-4, .last_time = 1e4}};
  const StageResult done = solve(study).stages[0];
  const auto& composite = preferred_test(done.tests, Load::shear, Boundary::displacement).series;

  fmt::print("\n{:>8}  {:>13}  {:>16}\n", "s [1/s]", "s G~(s) [MPa]", "elastic G [MPa]");
  double worst = 0.0;
  const auto& discs = *done.microstructure.content<Microstructure<2>>();
  const auto discretisation = discretise(box, discs, box.cells, study.tests.mixing);
  for (const double s : {1e-3, 1.0, 1e3}) {
    const Material transformed = {"binder at s", 1000.0, PronySeries(2e9), PronySeries(carson_of_law(s))};
    const double elastic = apparent_moduli<2>(
        {.discretisation = discretisation, .materials = materials_of(box, transformed)}, std::array{Load::shear})[0];
    fmt::print("{:8}  {:13.4f}  {:16.4f}\n", s, carson_of_series(composite, s) / 1e6, elastic / 1e6);
    worst = std::max(worst, std::abs(carson_of_series(composite, s) / elastic - 1.0));
  }
  // A relative error of the binder's modulus makes no larger one of the composite's.
  const bool is_right = worst < fit.quality.worst_error;
  fmt::print("\nThe composite is no further off than the fit of its binder: {}\n", is_right ? "yes" : "no");
  return is_right ? 0 : 1;
}

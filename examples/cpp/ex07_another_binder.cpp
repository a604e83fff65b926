// Example 7: the same microstructure with another binder and at another temperature. The solution of a study keeps a
// reduced response of each box, which answers for another matrix in milliseconds instead of a new solution.

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "breccia/homogenisation/responder.hpp"
#include "breccia/homogenisation/solve.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

using namespace breccia;

namespace {

/// Sixteen discs in a box of 8 mm, in a given matrix.
Study study_with(const Material& matrix) {
  const Material grain = {"grain", 2000.0, PronySeries(20e9), PronySeries(10e9)};
  const Filler filler = {.material = grain, .fraction = 0.25, .sizes = SingleSize{1.1e-3}, .gap = 0.25e-3};
  return {.stages = {{.name = "box", .matrix = matrix, .side = 8e-3, .cells = 64, .fillers = {filler}}},
          .tests = {.boundaries = {Boundary::displacement}, .first_time = 1e-3, .last_time = 10.0}};
}

/// G(t) of the only test of a stage.
const PronySeries& modulus_of(const StageResult& stage) {
  return preferred_test(stage.tests, Load::shear, Boundary::displacement).series;
}

}  // namespace

int main() {
  const Material binder = {"binder", 1000.0, PronySeries(1e9), PronySeries(0.1e6, {{1.0, 1e6}, {0.01, 5e6}})};
  const Study study = study_with(binder);
  const StudyResult solved = solve(study);
  const Responder responder = responder_of(study, solved);

  // At 40 degC the binder of 20 degC relaxes by the factor a_T faster.
  const WilliamsLandelFerry law = {.c1 = 6.5, .c2 = 120.0, .reference_temperature = 293.15};
  const double factor = law.shift_factor(313.15);
  const auto warm = responder.with({{"matrix", shifted(binder, factor)}}).respond();

  // Another binder has a bulk modulus and a spectrum of its own.
  const Material other = {"other binder", 1000.0, PronySeries(1.1e9), PronySeries(0.2e6, {{3.0, 1e6}, {0.05, 3e6}})};
  const auto exchanged = responder.with({{"matrix", other}}).respond();
  const StudyResult solved_anew = solve(study_with(other));

  fmt::print("a_T = {:.4f} at 40 degC\n\n{:>8}  {:>10}  {:>10}  {:>12}  {:>12}\n", factor, "G [MPa]", "20 degC",
             "40 degC", "other binder", "solved anew");
  double shift_error = 0.0, exchange_error = 0.0;
  for (const double time : {1e-3, 1e-2, 1e-1, 1.0, 10.0}) {
    const double g = modulus_of(solved.stages[0]).at(time), g_warm = modulus_of(warm[0]).at(time);
    const double g_other = modulus_of(exchanged[0]).at(time), g_anew = modulus_of(solved_anew.stages[0]).at(time);
    fmt::print("{:6} s  {:10.4f}  {:10.4f}  {:12.4f}  {:12.4f}\n", time, g / 1e6, g_warm / 1e6, g_other / 1e6,
               g_anew / 1e6);
    // Nothing but the binder's shear relaxes, so the whole composite is shifted by the same factor, exactly.
    shift_error = std::max(shift_error, std::abs(modulus_of(warm[0]).at(factor * time) / g - 1.0));
    exchange_error = std::max(exchange_error, std::abs(g_other / g_anew - 1.0));
  }
  // What two reduced bases differ by is of the order of the tolerance of their sampling, 1e-5.
  const bool is_right = shift_error < 1e-9 && exchange_error < 1e-4;
  fmt::print("\nThe shift is exact, and the other binder agrees with its own solution to 0.01 %: {}\n",
             is_right ? "yes" : "no");
  return is_right ? 0 : 1;
}

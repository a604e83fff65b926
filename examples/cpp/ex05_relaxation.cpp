// Example 5: the whole relaxation modulus G(t) of a composite, from a study that is put together in C++. No deck is
// read and no file is written. It is the first deck of the README, and the numbers are the same.

#include <fmt/format.h>

#include "breccia/homogenisation/solve.hpp"

using namespace breccia;

int main() {
  // Name, density [kg/m^3], bulk modulus and shear modulus [Pa]: those of the binder relax in shear alone.
  const Material binder = {"binder", 1000.0, PronySeries(1e6), PronySeries(0.0, {{0.01, 0.5e6}})};
  const Material particle = {"particle", 1500.0, PronySeries(50e6), PronySeries(18.8e6)};

  // Lengths in m: a box of 6 mm with discs of 2 mm, which fill 35 % of it and keep a gap of 0.1875 mm.
  const Filler filler = {.material = particle, .fraction = 0.35, .sizes = SingleSize{2e-3}, .gap = 0.1875e-3};
  const Stage composite = {.name = "composite",
                           .matrix = binder,
                           .side = 6e-3,
                           .cells = 96,
                           .fillers = {filler},
                           .packing = LubachevskyStillingerPacking<2>{.walls = Walls::hard, .seed = 1}};

  // Shear, by the quasi-static method, under the boundary conditions of the upper and of the lower bound.
  const Study study = {.stages = {composite}, .tests = {.first_time = 1e-3, .last_time = 0.1}};

  const StudyResult result = solve(study);

  const StageResult& done = result.stages[0];
  const TestResult& upper = preferred_test(done.tests, Load::shear, Boundary::displacement);
  const TestResult& lower = preferred_test(done.tests, Load::shear, Boundary::traction);
  fmt::print("{} discs, {:.1f} % of the box\n\n", done.microstructure.particles(),
             100.0 * done.microstructure.fraction);
  fmt::print("{:>8}  {:>18}  {:>18}\n", "t [s]", "upper bound [kPa]", "lower bound [kPa]");
  for (const double time : {1e-3, 1e-2, 1e-1}) {
    fmt::print("{:8}  {:18.3g}  {:18.3g}\n", time, upper.series.at(time) / 1e3, lower.series.at(time) / 1e3);
  }
  fmt::print("\nG(t) is a Prony series of {} terms above, {} below, and a table of {} times\n",
             upper.series.terms().size(), lower.series.terms().size(), upper.modulus.size());
  for (const auto& warning : done.warnings) fmt::print("warning: {}\n", warning);

  // At once after the load the composite is an elastic one, whose moduli lie between those of Reuss and Voigt.
  const double share = done.point_fraction, soft = binder.shear.unrelaxed(), hard = particle.shear.unrelaxed();
  const double voigt = (1.0 - share) * soft + share * hard, reuss = 1.0 / ((1.0 - share) / soft + share / hard);
  bool is_right = reuss <= lower.series.unrelaxed() && upper.series.unrelaxed() <= voigt;
  for (std::size_t i = 0; i < upper.modulus.size(); ++i) {
    is_right = is_right && lower.modulus[i].modulus <= upper.modulus[i].modulus;
  }
  fmt::print("The bounds are in order at all times: {}\n", is_right ? "yes" : "no");
  return is_right ? 0 : 1;
}

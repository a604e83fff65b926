// Example 5: the whole relaxation modulus G(t) of a composite, from a study that is put together in C++. No deck is
// read and no file is written. It is the first deck of the README, and the numbers are the same.

#include <cstddef>

#include <fmt/format.h>

#include "breccia/homogenisation/solve.hpp"

using namespace breccia;

int main() {
  // Name, density [kg/m^3], bulk modulus and shear modulus [Pa]: those of the binder relax in shear alone.
  const PronySeries relaxing(0.01e6, {{1e-3, 0.3e6}, {1e-2, 0.15e6}, {0.1, 0.05e6}});
  const Material binder = {"binder", 1000.0, PronySeries(1e6), relaxing};
  const Material particle = {"particle", 1500.0, PronySeries(50e6), PronySeries(18.8e6)};

  // Lengths in m: a periodic box of 20 mm with discs of 2 mm, which fill 50 % of it and keep a gap of 0.1 mm.
  const Filler filler = {.material = particle, .fraction = 0.5, .sizes = SingleSize{2e-3}, .gap = 0.1e-3};
  const Stage composite = {.name = "composite",
                           .matrix = binder,
                           .side = 20e-3,
                           .cells = 128,
                           .coarser_cells = {64},
                           .fillers = {filler},
                           .packing = LubachevskyStillingerPacking<2>{.walls = Walls::periodic, .seed = 1}};

  // Both shears of the box and their mean, by the quasi-static method; the binder flows through gaps below a cell.
  const Study study = {.stages = {composite},
                       .tests = {.loads = {TestLoad::isotropic()},
                                 .boundaries = {Boundary::periodic},
                                 .mixing = Mixing::flow,
                                 .first_time = 1e-3,
                                 .last_time = 1.0}};

  const StudyResult result = solve(study);

  const StageResult& done = result.stages[0];
  const auto test = [&done](TestLoad load) -> const TestResult& {
    return preferred_test(done.tests, load, Boundary::periodic);
  };
  const TestResult &mean = test(TestLoad::isotropic()), &xy = test(Load::shear), &xx_yy = test(Load::diagonal_shear);
  fmt::print("{} discs, {:.1f} % of the box\n\n", done.microstructure.particles(),
             100.0 * done.microstructure.fraction);
  fmt::print("{:>6}  {:>8}  {:>12}  {:>9}  {:>12}\n", "t [s]", "G [kPa]", "error [kPa]", "xy [kPa]", "xx-yy [kPa]");
  for (std::size_t i = 0; i < mean.modulus.size(); i += 20) {
    const auto& [time, modulus] = mean.modulus[i];
    fmt::print("{:6.4g}  {:8.3g}  {:12.2g}  {:9.3g}  {:12.3g}\n", time, modulus / 1e3, mean.half_bands[i] / 1e3,
               xy.modulus[i].modulus / 1e3, xx_yy.modulus[i].modulus / 1e3);
  }
  fmt::print("\nG(t) is a Prony series and a table of {} times\n", mean.modulus.size());
  for (const auto& warning : done.warnings) fmt::print("warning: {}\n", warning);

  // At once after the load the composite is an elastic one, whose modulus lies between those of Reuss and Voigt.
  const double share = done.point_fraction, soft = binder.shear.unrelaxed(), hard = particle.shear.unrelaxed();
  const double voigt = (1.0 - share) * soft + share * hard, reuss = 1.0 / ((1.0 - share) / soft + share / hard);
  const bool is_right = reuss <= mean.series.unrelaxed() && mean.series.unrelaxed() <= voigt;
  fmt::print("At first G is between the bounds of Reuss and Voigt: {}\n", is_right ? "yes" : "no");
  return is_right ? 0 : 1;
}

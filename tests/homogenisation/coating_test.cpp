#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/homogenisation/solve.hpp"

#include "homogenisation/stage_warnings.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::Not;

const Material host = {"host", 1000.0, PronySeries(3e9), PronySeries(1e9)};
const Material ceramic = {"ceramic", 2500.0, PronySeries(40e9), PronySeries(30e9)};
const Material soft_layer = {"soft_layer", 1200.0, PronySeries(1.5e9), PronySeries(0.1e9)};
const Material stiff_layer = {"stiff_layer", 1200.0, PronySeries(8e9), PronySeries(4e9)};

/// One coated cylinder in a periodic cell: it fills 1 % of the cell, and its core four fifths of its diameter.
Study coated_cylinder(const Material& coating, int cells) {
  const double outer = std::sqrt(0.04 / std::numbers::pi), core = 0.8 * outer;
  Filler filler = {.material = ceramic};
  filler.coating = Coating{coating, 0.5 * (outer - core)};
  Study study;
  study.stages = {{.name = "cell",
                   .matrix = host,
                   .side = 1.0,
                   .cells = cells,
                   .fillers = {filler},
                   .packing = ExplicitPacking<2>{"", std::vector{Disc{{0.5, 0.5}, core}}, Walls::periodic}}};
  study.tests.loads = {Load::shear, Load::diagonal_shear, Load::bulk};
  study.tests.boundaries = {Boundary::periodic};
  study.tests.first_time = 1.0;
  study.tests.last_time = 10.0;
  return study;
}

struct EffectiveModuli {
  double bulk;   ///< K + G/3 [Pa]
  double shear;  ///< mean of both shears of the square array [Pa]
};

EffectiveModuli moduli_of(const Study& study) {
  const auto result = solve(study);
  const auto& tests = result.stages.front().tests;
  const auto modulus = [&](Load load) {
    return preferred_test(tests, load, Boundary::periodic).modulus.front().modulus;
  };
  return {modulus(Load::bulk), 0.5 * (modulus(Load::shear) + modulus(Load::diagonal_shear))};
}

// Exact numbers from tests/reference/coated_cylinder.py. With 256 cells the coating is 2.9 cells wide. The coating is
// stiff, and the test compares the contribution of the cylinder to the moduli of the matrix.
TEST(Coating, OfADiluteCylinderHasTheExactModuli) {
  const auto computed = moduli_of(coated_cylinder(stiff_layer, 256));
  const double bulk = host.bulk.equilibrium() + host.shear.equilibrium() / 3.0, shear = host.shear.equilibrium();
  EXPECT_NEAR((computed.bulk - bulk) / (3368694859.0 - bulk), 1.0, 1e-3);
  EXPECT_NEAR((computed.shear - shear) / (1013883780.0 - shear), 1.0, 3e-3);
}

// A coating ten times softer than the matrix hides a particle thirty times stiffer: their contributions nearly cancel,
// so that the error is compared with the whole modulus, for a hundredth of the area.
TEST(Coating, SofterThanTheMatrixHidesItsParticle) {
  const auto computed = moduli_of(coated_cylinder(soft_layer, 256));
  EXPECT_NEAR(computed.bulk / 3340487199.0, 1.0, 1e-4);
  EXPECT_NEAR(computed.shear / 998309900.0, 1.0, 1.2e-3);
}

// A coating of the material of its particle makes a larger particle, and a coating of the material of the matrix has no
// effect.
TEST(Coating, OfTheMaterialOfItsParticleMakesALargerParticle) {
  const auto coated = coated_cylinder(ceramic, 64);
  auto whole = coated;
  whole.stages[0].fillers[0].coating.reset();
  auto& discs = std::get<std::vector<Disc>>(whole.stages[0].packed_by<ExplicitPacking<2>>()->particles);
  discs[0].diameter += 2.0 * coated.stages[0].fillers[0].coating->thickness;
  const auto one = moduli_of(coated), other = moduli_of(whole);
  EXPECT_NEAR(one.bulk / other.bulk, 1.0, 1e-9);
  EXPECT_NEAR(one.shear / other.shear, 1.0, 1e-9);
}

TEST(Coating, ThinnerThanTwoCellsIsWarnedOf) {
  const auto thin = coated_cylinder(stiff_layer, 128), resolved = coated_cylinder(stiff_layer, 256);
  const auto warnings_of = [](const Study& study) {
    const auto& stage = study.stages.front();
    std::string all;
    for (const auto& warning : warnings_on(study, stage, make_microstructure(stage))) all += warning + "\n";
    return all;
  };
  EXPECT_THAT(warnings_of(thin), HasSubstr("the thinnest coating, "));
  EXPECT_THAT(warnings_of(thin), HasSubstr("cells = 178 would resolve it"));
  EXPECT_THAT(warnings_of(resolved), Not(HasSubstr("the thinnest coating")));
}

// Steps in log time and explicit motion treat histories of their own in each phase of a mixed cell, or of the mixture;
// the reduced basis has parts for the moduli of the coating.
TEST(Coating, ThatRelaxesIsTheSameByAllMethods) {
  const Material rubber = {"rubber", 1000.0, PronySeries(1e6), PronySeries(0.0, {{0.01, 0.5e6}})};
  const Material layer = {"layer", 1000.0, PronySeries(3e6), PronySeries(0.5e6, {{0.003, 1.5e6}})};
  const Material disc = {"disc", 1500.0, PronySeries(50e6), PronySeries(18.8e6)};
  Filler filler = {.material = disc, .sizes = SingleSize{2e-3}};
  filler.coating = Coating{layer, 0.4e-3};
  Study study;
  study.stages = {{.name = "discs",
                   .matrix = rubber,
                   .side = 6e-3,
                   .cells = 30,
                   .fillers = {filler},
                   .packing = RegularPacking{2, 2}}};
  study.tests.boundaries = {Boundary::displacement};
  study.tests.methods = {Method::quasistatic, Method::dynamic};
  study.tests.quasistatic.solver = Solver::stepping;
  study.tests.first_time = 1e-3;
  study.tests.last_time = 50e-3;
  const auto tests = solve(study).stages.front().tests;
  study.tests.methods = {Method::quasistatic};
  study.tests.quasistatic.solver = Solver::reduced;
  const auto reduced_tests = solve(study).stages.front().tests;
  const auto& reduced = preferred_test(reduced_tests, Load::shear, Boundary::displacement).modulus;
  const auto& steps = preferred_test(tests, Load::shear, Boundary::displacement, Method::quasistatic).modulus;
  const auto& motion = preferred_test(tests, Load::shear, Boundary::displacement, Method::dynamic).modulus;
  ASSERT_EQ(steps.size(), motion.size());
  ASSERT_EQ(steps.size(), reduced.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_NEAR(motion[i].modulus / steps[i].modulus, 1.0, 2e-3) << steps[i].time;
    EXPECT_NEAR(reduced[i].modulus / steps[i].modulus, 1.0, 5e-4) << steps[i].time;
  }
}

TEST(Coating, IsPartOfTheDensityOfItsStage) {
  auto study = coated_cylinder(stiff_layer, 32);
  study.tests.loads = {Load::shear, Load::bulk};
  auto next = study.stages.front();
  next.name = "next";
  next.matrix = EarlierStage{"cell"};
  next.fillers.clear();
  study.stages.push_back(next);
  const auto result = solve(study);
  const double core = 0.64 * 0.01, coating = 0.36 * 0.01;
  EXPECT_NEAR(result.stages.front().materials.front().result.material.density,
              0.99 * 1000.0 + core * 2500.0 + coating * 1200.0, 1e-6);
}

}  // namespace
}  // namespace breccia

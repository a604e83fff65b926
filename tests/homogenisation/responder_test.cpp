#include "breccia/homogenisation/responder.hpp"

#include <cmath>
#include <complex>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/solve.hpp"

#include "messages.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const WilliamsLandelFerry law = {.c1 = 6.5, .c2 = 120.0, .reference_temperature = 293.15};

/// A binder of two terms, 1 and 10 ms, at 20 degC.
Material two_terms() {
  return {"binder", 1000.0, PronySeries(1e9), PronySeries(1e4, {{1e-2, 0.3e6}, {1e-3, 0.2e6}})};
}

/// One coarse box of four discs, so that a run warns of its gaps, and of times beyond its binder where the last is
/// long.
Study small_study(const Material& binder, double last_time = 50e-3) {
  auto study = test::two_stages();
  study.materials = {{binder, TemperatureShift{law, 293.15}}, {test::glass}};
  study.stages = {test::four_discs("box", binder, 6e-3, 8)};
  study.provenance.warnings["box"] = {"a warning of the deck"};
  study.tests.boundaries = {Boundary::displacement};
  study.tests.last_time = last_time;
  return study;
}

Responder solved(const Study& study) {
  return responder_of(study, solve(study));
}

TEST(Responder, CarriesTheWarningsOfTheStudyThatDoNotDependOnTheMaterials) {
  const auto study = small_study(two_terms(), 1.0);
  const auto result = solve(study);
  ASSERT_THAT(result.stages[0].warnings, Contains(HasSubstr("times end at 1 s")));
  const auto responder = responder_of(study, result);
  EXPECT_EQ(responder.respond().front().warnings, result.stages[0].warnings) << "for its own binder, all of them";
  const Material slow = {"slow", 1000.0, PronySeries(1e9), PronySeries(1e4, {{1.0, 0.3e6}, {1e-3, 0.2e6}})};
  const auto warnings = responder.with({{"matrix", slow}}).respond().front().warnings;
  EXPECT_THAT(warnings, Contains("box: a warning of the deck"));
  EXPECT_THAT(warnings, Not(Contains(HasSubstr("times end at"))));
  const auto of_short = responder.within({1e-3, 20e-3}).respond().front().warnings;
  EXPECT_THAT(of_short, Contains("box: a warning of the deck"));
  EXPECT_THAT(of_short, Not(Contains(HasSubstr("times end at"))));
}

TEST(Responder, WarnsOfTimesBeyondTheSpectrumAtATemperature) {
  const auto responder = solved(small_study(two_terms()));
  EXPECT_THAT(responder.respond().front().warnings, Not(Contains(HasSubstr("times end at"))));
  const auto hot = responder.at(353.15);
  EXPECT_THAT(hot.shown_names(), ElementsAre("binder at 80 degC"));
  EXPECT_THAT(hot.respond().front().warnings, Contains(HasSubstr("of its matrix, binder at 80 degC, ")));
  EXPECT_EQ(hot.materials().front().material.name, "binder") << "as in the study";
  EXPECT_EQ(hot.materials().front().shift->temperature, 353.15);
  const auto back = hot.at(293.15).respond();
  EXPECT_THAT(back.front().warnings, Not(Contains(HasSubstr("times end at"))));
}

TEST(Responder, WarnsThatAnElasticMatrixIsTheSameAtAllTemperatures) {
  const Material elastic = {"binder", 1000.0, PronySeries(1e9), PronySeries(1e6)};
  const auto responder = solved(small_study(elastic));
  const auto warning = HasSubstr("binder is elastic: its moduli do not depend on the temperature here");
  const auto warm = responder.at(313.15);
  EXPECT_THAT(warm.respond().front().warnings, Contains(warning));
  EXPECT_THAT(responder.respond().front().warnings, Not(Contains(warning)));
  const Material other = {"other", 1000.0, PronySeries(1e9), PronySeries(1.02e6)};
  EXPECT_THAT(warm.with({{"matrix", other}}).respond().front().warnings, Not(Contains(warning)));
}

TEST(Responder, RefusesATemperatureWithoutALaw) {
  auto study = small_study(two_terms());
  study.materials.at(0).shift.reset();
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(solved(study).at(313.15)); }),
              HasSubstr("binder has no temperature_shift"));
}

TEST(Responder, AsksAgainFromWhatItHas) {
  const auto responder = solved(small_study(two_terms()));
  const auto warm = responder.at(313.15).within({2e-3, 20e-3});
  const Responder again(warm.stages(), warm.materials());
  const auto one = warm.at(303.15).respond().front(), other = again.at(303.15).respond().front();
  EXPECT_EQ(one.tests.front().modulus, other.tests.front().modulus);
  EXPECT_EQ(one.tests.front().modulus.front().time, 2e-3);
  EXPECT_EQ(one.warnings, other.warnings);
}

TEST(Responder, TakesOneStageWithAMatrixOfItsOwnOrItsChain) {
  const auto study = test::two_stages();
  const auto responder = solved(study);
  EXPECT_EQ(responder.chain_of("fine").respond().size(), 1U);
  EXPECT_EQ(responder.chain_of("coarse").respond().size(), 2U);
  const auto alone = responder.alone("coarse");
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(alone.respond()); }),
              HasSubstr("no new material for \"fine\", which is the matrix of a stage"));
  const Material filled = {"filled", 1000.0, PronySeries(1.45e9), PronySeries(5e4, {{1e-2, 0.5e6}})};
  EXPECT_EQ(alone.with({{"matrix", filled}}).respond().size(), 1U);
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(responder.alone("medium")); }),
              HasSubstr("no response of a stage \"medium\""));
}

// Particles of the moduli of the matrix: the strain is uniform, so that the derivatives are shares of the volume. In
// plane strain the test under bulk has K + G/3.
TEST(ResponderGradient, OfAHomogeneousChainIsTheShareOfItsMaterial) {
  const Moduli moduli = {.bulk = 3e9, .shear = 1e9};
  const Material elastic = {"binder", 1000.0, PronySeries(moduli.bulk), PronySeries(moduli.shear)};
  auto study = test::two_stages();
  study.materials = {{elastic}, {test::glass}};
  study.stages[0].matrix = elastic;
  study.tests.loads = {Load::shear, Load::bulk};
  for (auto& stage : study.stages) {
    stage.fillers[0].material = elastic;
    stage.fillers[0].material.name = "filler of the same moduli";
    stage.cells = 6;
  }
  const auto result = solve(study);
  const auto responder = responder_of(study, result);
  double share = 1.0;
  for (const auto& stage : result.stages) {
    share *= 1.0 - stage.point_fraction;
    const auto of_load = [&](Load load) {
      return responder.modulus_and_gradient(stage.name, load, Boundary::displacement,
                                            {{"binder", {moduli.bulk, moduli.shear}}});
    };
    const auto shear = of_load(Load::shear), bulk = of_load(Load::bulk);
    EXPECT_NEAR(shear.modulus.real() / moduli.shear, 1.0, 1e-9) << stage.name;
    EXPECT_NEAR(bulk.modulus.real() / (moduli.bulk + moduli.shear / 3.0), 1.0, 1e-9) << stage.name;
    EXPECT_NEAR(shear.gradient.at("binder").shear.real(), share, 1e-6) << stage.name;
    EXPECT_NEAR(shear.gradient.at("binder").bulk.real(), 0.0, 1e-6) << stage.name;
    EXPECT_NEAR(bulk.gradient.at("binder").bulk.real(), share, 1e-6) << stage.name;
    EXPECT_NEAR(bulk.gradient.at("binder").shear.real(), share / 3.0, 1e-6) << stage.name;
  }
}

// The derivatives are taken through both stages, at a Laplace variable and at a hundred times that.
TEST(ResponderGradient, OfAChainAgreesWithFiniteDifferences) {
  const auto responder = solved(test::two_stages());
  for (const double s : {20.0, 2000.0}) {
    const auto at = carson_moduli(test::binder, s);
    const auto [modulus, gradient] = responder.modulus_and_gradient("coarse", Load::shear, Boundary::displacement, s);
    ASSERT_EQ(gradient.size(), 1U);
    const auto modulus_at = [&](const Moduli& moduli) {
      return responder
          .modulus_and_gradient("coarse", Load::shear, Boundary::displacement,
                                {{"binder", {moduli.bulk, moduli.shear}}})
          .modulus.real();
    };
    constexpr double step = 1e-4;
    const auto difference = [&](double Moduli::*which) {
      auto more = at, less = at;
      more.*which *= 1.0 + step;
      less.*which *= 1.0 - step;
      return (modulus_at(more) - modulus_at(less)) / (2.0 * step * at.*which);
    };
    EXPECT_NEAR(modulus.real() / modulus_at(at), 1.0, 1e-14);
    EXPECT_NEAR(gradient.at("binder").shear.real() / difference(&Moduli::shear), 1.0, 1e-6) << s;
    // The modulus hardly depends on K: its derivative is small compared with G/K, and so is the difference compared
    // with rounding errors.
    EXPECT_NEAR(gradient.at("binder").bulk.real(), difference(&Moduli::bulk), 1e-6 * modulus.real() / at.shear) << s;
  }
}

// The series of a curve is exact for the reduced response of a single stage.
TEST(ResponderGradient, AtAFrequencyIsTheComplexModulusOfTheCurve) {
  const auto study = small_study(two_terms());
  const auto responder = solved(study);
  const auto results = responder.respond();
  const auto& test = results.front().tests.front();
  for (const double omega : {1.0, 200.0, 1e4}) {
    const auto at =
        responder.modulus_and_gradient("box", test.id.load, test.id.boundary, std::complex<double>(0.0, omega));
    EXPECT_LT(std::abs(at.modulus / test.series.complex_modulus(omega) - 1.0), 1e-9) << omega;
  }
}

TEST(ResponderGradient, RefusesTestsThatWereNotRun) {
  const auto responder = solved(small_study(two_terms()));
  EXPECT_THAT(test::message_of<InputError>([&] {
                static_cast<void>(responder.modulus_and_gradient("box", Load::bulk, Boundary::traction, 1.0));
              }),
              HasSubstr("stage box has no reduced response under bulk with the traction boundary"));
}

}  // namespace
}  // namespace breccia

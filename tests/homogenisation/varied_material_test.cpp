// Tests of elastic materials whose moduli are not known: one run serves all values of these moduli.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/responder.hpp"
#include "breccia/homogenisation/solve.hpp"

#include "homogenisation/plan/cell_memory.hpp"
#include "homogenisation/plan/expected_snapshots.hpp"
#include "homogenisation/respond/not_covered.hpp"
#include "homogenisation/respond/replaced_materials.hpp"
#include "homogenisation/varying_phases.hpp"
#include "messages.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Material interphase(double shear, double bulk = 2e9) {
  return {"interphase", 1200.0, PronySeries(bulk), PronySeries(shear)};
}

/// A binder that relaxes from 900 MPa to 1 MPa, and coated discs in it.
Study coated_discs(const Material& coating) {
  Study study = test::two_stages();
  study.stages.resize(1);
  auto& stage = study.stages.front();
  stage.matrix = Material{"binder", 1000.0, PronySeries(3e9),
                          PronySeries(1e6, {{1e-5, 500e6}, {1e-3, 300e6}, {1e-2, 90e6}, {0.1, 9e6}})};
  stage.fillers.front().coating = Coating{coating, 0.3e-3};
  study.tests.boundaries = {Boundary::displacement, Boundary::traction};
  study.tests.quasistatic.sampling.tolerance = 1e-4;
  study.tests.points_per_decade = 5;
  return study;
}

double largest_difference(const StageResult& found, const StageResult& expected) {
  double largest = 0.0;
  EXPECT_EQ(found.tests.size(), expected.tests.size());
  for (const auto& test : expected.tests) {
    const auto& other = preferred_test(found.tests, test.id.load, test.id.boundary);
    for (std::size_t i = 0; i < test.modulus.size(); ++i) {
      largest = std::max(largest, std::abs(other.modulus[i].modulus / test.modulus[i].modulus - 1.0));
    }
  }
  return largest;
}

TEST(VariedCoating, OneRunAnswersForAllModuliOfItsIntervals) {
  auto study = coated_discs(interphase(100e6));
  study.tests.varied = {{"interphase", ModulusInterval{10e6, 1e9}, ModulusInterval{1e9, 4e9}}};
  const auto responses = responses_of(study, solve(study));
  for (const auto& coating :
       {interphase(10e6), interphase(1e9, 4e9), interphase(33e6, 1e9), interphase(470e6, 1.7e9)}) {
    const auto answer = Responder(responses).with({{"interphase", coating}}).respond().front();
    const auto run = solve(coated_discs(coating)).stages.front();
    EXPECT_LT(largest_difference(answer, run), 1e-3) << coating.shear.equilibrium();
  }
}

// A coating whose moduli are in the interval at all times may also relax.
TEST(VariedCoating, ACoatingThatRelaxesWithinTheIntervalMayTakeItsPlace) {
  auto study = coated_discs(interphase(100e6));
  study.tests.varied = {{"interphase", ModulusInterval{10e6, 1e9}, {}}};
  const auto responses = responses_of(study, solve(study));
  auto relaxing = interphase(20e6);
  relaxing.shear = PronySeries(20e6, {{3e-3, 200e6}});
  const auto answer = Responder(responses).with({{"interphase", relaxing}}).respond().front();
  EXPECT_LT(largest_difference(answer, solve(coated_discs(relaxing)).stages.front()), 5e-3);
}

// The fine stage becomes stiffer or softer with its coating, and the range that the coarse stage samples changes with
// it.
TEST(VariedCoating, OfAnEarlierStageVariesTheMatrixOfTheNext) {
  const auto chain_with = [](const Material& coating) {
    auto study = coated_discs(coating);
    study.stages.push_back(test::two_stages().stages.back());
    study.tests.boundaries = {Boundary::displacement};
    study.tests.fit_tolerance = 0.01;
    return study;
  };
  auto study = chain_with(interphase(100e6));
  study.tests.varied = {{"interphase", ModulusInterval{10e6, 1e9}, {}}};
  const auto responses = responses_of(study, solve(study));
  for (const double shear : {10e6, 1e9}) {
    const auto answers = Responder(responses).with({{"interphase", interphase(shear)}}).respond();
    const auto run = solve(chain_with(interphase(shear)));
    EXPECT_LT(largest_difference(answers.at(0), run.stages.at(0)), 1e-3) << shear;
    EXPECT_LT(largest_difference(answers.at(1), run.stages.at(1)), 5e-3) << shear;
  }
}

TEST(VariedCoating, IsRefusedBeyondItsInterval) {
  auto study = coated_discs(interphase(100e6));
  study.stages.front().cells = 8;
  study.tests.boundaries = {Boundary::displacement};
  study.tests.varied = {{"interphase", ModulusInterval{50e6, 200e6}, {}}};
  const auto responses = responses_of(study, solve(study));
  const auto refusal_of = [&](const Material& coating) {
    return test::message_of<NotCovered>([&] {
      static_cast<void>(Responder(responses).with({{"interphase", coating}}).respond());
    });
  };
  EXPECT_THAT(refusal_of(interphase(1e9)),
              AllOf(HasSubstr("interphase shows a shear modulus of 1 GPa; the responses hold from 47.5 MPa "
                              "to 210 MPa"),
                    HasSubstr("are sampled with tests.quasistatic.vary")));
  EXPECT_THAT(refusal_of(interphase(100e6, 5e9)), HasSubstr("interphase shows a bulk modulus of 5 GPa"));
}

TEST(VariedCoating, IsAPhaseThatVariesOnlyWhereItIsAskedFor) {
  auto study = coated_discs(interphase(100e6));
  const auto& stage = study.stages.front();
  EXPECT_TRUE(other_varying_phases(study.tests, stage).empty());
  study.tests.varied = {{"interphase", ModulusInterval{10e6, 1e9}, {}}};
  EXPECT_TRUE(other_varying_phases(study.tests, stage).contains("interphase"));
}

// With a hundred cells a side there are 20 000 unknowns, with 8 bytes each in a snapshot.
TEST(VariedCoating, TakesMoreSnapshotsAndTheirMemory) {
  auto study = coated_discs(interphase(100e6));
  const auto& stage = study.stages.front();
  const double bytes = quasistatic_memory(study, stage, 100), snapshots = expected_snapshots(study, stage);
  study.tests.varied = {{"interphase", ModulusInterval{10e6, 1e9}, {}}};
  const double over_shear = expected_snapshots(study, stage);
  study.tests.varied.front().bulk = ModulusInterval{1e9, 10e9};
  const double over_both = expected_snapshots(study, stage);
  EXPECT_GT(over_shear, 2.0 * snapshots) << "two decades";
  EXPECT_NEAR((over_both / over_shear - 1.0) / (over_shear / snapshots - 1.0), 0.5, 1e-9) << "one decade more";
  EXPECT_GT(quasistatic_memory(study, stage, 100) - bytes, 20000.0 * 8.0 * (over_both - 11.0));
}

/// Responses whose matrix, coating and filler vary, without data for a computation.
std::vector<StageResponses> names_alone() {
  StageResponses fine, coarse;
  fine.stage = "fine";
  fine.matrix = test::binder;
  fine.other_phases = {{"interphase", interphase(1e8)}, {"filler", test::glass}};
  coarse.stage = "coarse";
  coarse.matrix = EarlierStage{"fine"};
  coarse.other_phases = {{"filler", Material{"sand", 1e3, PronySeries(1e9), PronySeries(1e9)}}};
  return {fine, coarse};
}

TEST(NewMaterials, AreGivenByTheNameOfAMaterialOrOfAPhase) {
  const auto soft = interphase(1e6);
  const auto by_name = [&](const std::string& name) {
    return replaced_materials({{name, soft}}, names_alone(), {}).front();
  };
  EXPECT_EQ(by_name("binder"), "binder");
  EXPECT_EQ(by_name("matrix"), "binder");
  EXPECT_EQ(by_name("interphase"), "interphase");
  EXPECT_EQ(by_name("sand"), "sand");
}

TEST(NewMaterials, MistakesAreToldAtOnce) {
  const auto one = interphase(1e6);
  const Material rigid = {"steel", 7800.0, PronySeries(160e9), PronySeries(80e9)};
  const auto message = test::message_of<InputError>([&] {
    static_cast<void>(replaced_materials(
        {{"interfase", one}, {"filler", one}, {"binder", one}, {"matrix", one}, {"steel", one}, {"quartz", one}},
        names_alone(), {{test::binder}, {rigid}}));
  });
  EXPECT_THAT(message, HasSubstr("no material or phase \"interfase\" varies, did you mean \"interphase\"?\n"));
  EXPECT_THAT(message, HasSubstr("filler stands for several materials of the stages, glass, sand; give the name of"));
  EXPECT_THAT(message, HasSubstr("binder is given twice (also as matrix)\n"));
  EXPECT_THAT(message,
              HasSubstr("steel does not vary: its phase is elastic, and the run has sampled no other moduli of "
                        "it; write tests.quasistatic.vary = { \"steel\" = { shear = [\"8 GPa\", \"800 GPa\"] "
                        "} }"));
  EXPECT_THAT(message, HasSubstr("no material or phase \"quartz\" varies; known: "));
}

}  // namespace
}  // namespace breccia

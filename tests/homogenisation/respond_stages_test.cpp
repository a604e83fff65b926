// Tests of responses of composites whose moduli are linear in those of their matrix, so that the results are known.

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/responder.hpp"

#include "homogenisation/respond/not_covered.hpp"
#include "messages.hpp"
#include "one_vector_response.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A stage whose composite has the moduli in_shear G, and in the plane K + in_shear G / 3.
StageResponses linear_stage(const std::string& name, StageMatrix matrix, double in_shear) {
  StageResponses stored;
  stored.stage = name;
  stored.matrix = std::move(matrix);
  stored.side = 1.0;
  stored.deck_hash = "0123456789abcdef";
  stored.fit_tolerance = 0.03;
  stored.times = {1e-3, 50e-3};
  const std::vector<Snapshot> snapshots = {{{{.bulk = 1e9, .shear = 1e8}}, 0.0}, {{{.bulk = 1e9, .shear = 1e3}}, 0.0}};
  for (const auto& [load, composite] : {std::pair{Load::shear, test::LinearComposite{0.0, in_shear, 0.0}},
                                        std::pair{Load::bulk, test::LinearComposite{0.0, in_shear / 3.0, 1.0}}}) {
    stored.entries.push_back({TestGrid(12), test::one_vector_response(load, Boundary::traction, composite, snapshots)});
  }
  return stored;
}

// The moduli are twice those of the binder, and three times that.
TEST(Respond, TakesWhatAStageMakesOfTheMatrixAsTheMatrixOfTheNext) {
  const auto answers =
      Responder({linear_stage("coarse", EarlierStage{"fine"}, 3.0), linear_stage("fine", test::binder, 2.0)}).respond();
  ASSERT_THAT(answers, SizeIs(2));
  EXPECT_EQ(answers[0].name, "fine") << "in the order in which they build on each other";
  EXPECT_EQ(answers[1].name, "coarse");
  const auto modulus = [&](std::size_t stage, double time) {
    return preferred_test(answers[stage].tests, Load::shear, Boundary::traction).series.at(time);
  };
  for (const double time : {1e-3, 1e-2, 5e-2}) {
    EXPECT_NEAR(modulus(0, time) / (2.0 * test::binder.shear.at(time)), 1.0, 1e-9) << time;
    EXPECT_NEAR(modulus(1, time) / (6.0 * test::binder.shear.at(time)), 1.0, 0.03) << time << ", through a fit";
  }
}

TEST(Respond, TellsTheCreepComplianceUnderATraction) {
  const Material elastic{"elastic", 1e3, PronySeries(1e9), PronySeries(1e6)};
  const auto answer =
      Responder({linear_stage("fine", test::binder, 2.0)}).with({{"matrix", elastic}}).respond().front();
  const auto& in_shear = preferred_test(answer.tests, Load::shear, Boundary::traction);
  ASSERT_EQ(in_shear.compliance.size(), in_shear.modulus.size());
  EXPECT_NEAR(in_shear.compliance.front().compliance * 2e6, 1.0, 1e-12);
  EXPECT_EQ(in_shear.modulus.front().time, 1e-3);
  EXPECT_EQ(in_shear.modulus.back().time, 50e-3);
}

TEST(Respond, RefusesStagesThatDoNotBelongTogether) {
  const auto fine = linear_stage("fine", test::binder, 2.0);
  const auto refusal_of = [](const std::vector<StageResponses>& stored) {
    return test::message_of<InputError>([&] { static_cast<void>(Responder(stored).with({{"matrix", test::binder}})); });
  };
  EXPECT_THAT(Responder({}).respond(), IsEmpty());
  EXPECT_THAT(refusal_of({fine, linear_stage("coarse", EarlierStage{"middle"}, 3.0)}),
              HasSubstr("stage coarse: its matrix is the result of stage middle, of which there is no response"));
  auto elsewhere = linear_stage("coarse", EarlierStage{"fine"}, 3.0);
  elsewhere.deck_hash = "fedcba9876543210";
  EXPECT_THAT(
      refusal_of({fine, elsewhere}),
      HasSubstr("the responses of stages fine and coarse are of different studies (deck hashes 0123456789abcdef "
                "and fedcba9876543210)"));
  EXPECT_THAT(refusal_of({fine, linear_stage("other", test::glass, 3.0)}),
              HasSubstr("matrix stands for several materials of the stages, binder, glass; give the name of one"));
  EXPECT_EQ(refusal_of({fine, linear_stage("coarse", EarlierStage{"fine"}, 3.0), fine}),
            "the responses of stage fine are given twice; give those of each stage once");
}

TEST(Respond, TakesAMaterialForEachThatStagesHaveAsTheirMatrix) {
  const std::vector<StageResponses> stored = {linear_stage("fine", test::binder, 2.0),
                                              linear_stage("other", test::glass, 3.0)};
  const Material soft{"soft", 1e3, PronySeries(1e9), PronySeries(1e4)},
      hard{"hard", 1e3, PronySeries(1e9), PronySeries(1e7)};
  const auto both = Responder(stored).with({{"binder", soft}, {"glass", hard}}).respond();
  EXPECT_NEAR(both.at(0).tests.at(0).modulus.front().modulus / 2e4, 1.0, 1e-9);
  EXPECT_NEAR(both.at(1).tests.at(0).modulus.front().modulus / 3e7, 1.0, 1e-9);
}

// A file holds only the name of the matrix.
TEST(Respond, NeedsTheModuliOfEachMatrix) {
  const std::vector<StageResponses> stored = {linear_stage("fine", test::binder, 2.0),
                                              linear_stage("other", Material{"gel", 0.0, {}, {}}, 3.0)};
  const Material soft{"soft", 1e3, PronySeries(1e9), PronySeries(1e4)};
  EXPECT_THAT(test::message_of<InputError>([&] {
                static_cast<void>(Responder(stored).with({{"binder", soft}}).respond());
              }),
              HasSubstr("no new material for \"gel\", which is the matrix of a stage"));
  const Material gel{"gel", 1e3, PronySeries(1e9), PronySeries(1e7)};
  EXPECT_NEAR(Responder(stored, {{gel}}).respond().at(1).tests.at(0).modulus.front().modulus / 3e7, 1.0, 1e-9);
}

/// The binder and a coating: the modulus 2 G + 5 G_coating, sampled from 10 to 100 kPa of the coating.
StageResponses coated_stage() {
  auto stored = linear_stage("fine", test::binder, 2.0);
  stored.entries.pop_back();
  auto& response = stored.entries.front().response;
  response.parts.push_back({{"coating", ElasticModulus::shear}, Eigen::MatrixXd::Constant(1, 1, 5.0)});
  response.parts.push_back({{"coating", ElasticModulus::bulk}, Eigen::MatrixXd::Zero(1, 1)});
  response.residual_products = Eigen::MatrixXd::Zero(6, 6);
  for (auto& snapshot : response.snapshots) snapshot.moduli.push_back({.bulk = 1e9, .shear = 1e5});
  response.snapshots.back().moduli.back().shear = 1e4;
  stored.other_phases.emplace("coating",
                              Material{"interphase", 1e3, PronySeries(1e9), PronySeries(2e4, {{1e-2, 7e4}})});
  return stored;
}

TEST(RespondWithSeveralPhases, KeepsTheCoatingOrTakesAnotherByTheNameOfItsMaterial) {
  const auto stored = coated_stage();
  const Material soft{"soft", 1e3, PronySeries(1e9), PronySeries(1e4, {{2e-2, 1e5}})};
  const Material stiffer{"stiffer", 1e3, PronySeries(1e9), PronySeries(5e4, {{5e-3, 5e4}})};
  const auto modulus = [](const std::vector<StageResult>& answer, double time) {
    return preferred_test(answer.at(0).tests, Load::shear, Boundary::traction).series.at(time);
  };
  const auto kept = Responder({stored}).with({{"binder", soft}}).respond();
  const auto replaced = Responder({stored}).with({{"binder", soft}, {"interphase", stiffer}}).respond();
  for (const double time : {1e-3, 1e-2, 5e-2}) {
    const auto& interphase = stored.other_phases.at("coating");
    EXPECT_NEAR(modulus(kept, time) / (2.0 * soft.shear.at(time) + 5.0 * interphase.shear.at(time)), 1.0, 1e-9);
    EXPECT_NEAR(modulus(replaced, time) / (2.0 * soft.shear.at(time) + 5.0 * stiffer.shear.at(time)), 1.0, 1e-9);
  }
}

TEST(RespondWithSeveralPhases, RefusesACoatingBeyondWhatWasSampled) {
  const Material hard{"hard", 1e3, PronySeries(1e9), PronySeries(1e6)};
  EXPECT_EQ(
      test::message_of<NotCovered>([&] {
        static_cast<void>(Responder({coated_stage()}).with({{"interphase", hard}}).respond());
      }),
      "stage fine: from 1 ms to 50 ms hard shows a shear modulus of 1 MPa; the responses hold from "
      "9.5 kPa to 105 kPa\na new study with these materials covers all of them; moduli of elastic materials between "
      "two ends are sampled with tests.quasistatic.vary");
  auto incomplete = coated_stage();
  incomplete.other_phases.clear();
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(Responder({incomplete}).respond()); }),
              HasSubstr("the phase coating has no material"));
}

}  // namespace
}  // namespace breccia

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/responder.hpp"
#include "breccia/homogenisation/solve.hpp"

#include "messages.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

const StageResult& last(const std::vector<StageResult>& stages) {
  return stages.back();
}

TEST(ResponsesOf, AStudyAnswerForItsOwnBinderAsItsSolution) {
  const auto study = test::two_stages();
  const auto solved = solve(study);
  const auto responses = responses_of(study, solved);
  ASSERT_THAT(responses, SizeIs(2));
  EXPECT_EQ(responses[0].side, study.stages[0].side);
  EXPECT_THAT(responses[0].entries, SizeIs(solved.stages[0].tests.size()));
  const auto answered = responder_of(study, solved).respond();
  ASSERT_THAT(answered, SizeIs(2));
  for (const auto& test : last(solved.stages).tests) {
    const auto& other = preferred_test(last(answered).tests, test.id.load, test.id.boundary);
    EXPECT_EQ(other.modulus, test.modulus) << name_of(test.id.boundary);
  }
}

// If only the shear modulus of the binder relaxes, a factor on its times multiplies the times of the composite, too.
TEST(ResponsesOf, AStageAnswersAtAnotherTemperatureByAShiftOfTime) {
  auto study = test::two_stages();
  study.stages.pop_back();
  study.tests.loads = {Load::shear};
  const auto solved = solve(study);
  const auto stored = responses_of(study, study.stages[0], solved.stages[0]);
  constexpr double factor = 0.05;
  const auto warm = Responder({stored}).with({{"binder", shifted(test::binder, factor)}}).respond().front();
  for (const auto& [time, modulus] : preferred_test(solved.stages[0].tests, Load::shear, Boundary::traction).modulus) {
    const auto& series = preferred_test(warm.tests, Load::shear, Boundary::traction).series;
    EXPECT_NEAR(series.at(factor * time) / modulus, 1.0, 1e-9) << time;
  }
}

TEST(ResponsesOf, TestsWithoutAReducedBasisLeaveNone) {
  auto study = test::two_stages();
  study.tests.quasistatic.solver = Solver::stepping;
  EXPECT_THAT(responses_of(study, solve(study)), IsEmpty());
}

/// A single stage under one load and boundary, in a box of some size [m].
Study small_study(double side) {
  auto study = test::two_stages();
  study.stages = {test::four_discs("fine", test::binder, side, 8)};
  study.tests.boundaries = {Boundary::displacement};
  return study;
}

// The warning of the run compares the filler with the binder of the study; the warning of a response compares it with
// the new binder.
TEST(Respond, TheWarningOfASoftFillerIsThatOnTheNewBinder) {
  auto study = small_study(6e-3);
  auto soft = study.stages[0].fillers[0].material;
  soft.name = "soft";
  soft.bulk = PronySeries(1e3);
  soft.shear = PronySeries(1e2);
  study.stages[0].fillers[0].material = soft;
  study.materials.push_back({soft});
  const auto solved = solve(study);
  const auto is_softer_than = [](const std::string& binder) {
    return Contains(HasSubstr("the filler, soft, is softer than the binder, " + binder + ":"));
  };
  EXPECT_THAT(solved.stages[0].warnings, is_softer_than("binder"));
  const auto responder = responder_of(study, solved);
  EXPECT_THAT(responder.respond().front().warnings, is_softer_than("binder"));
  const Material other = {"other", 1000.0, PronySeries(1e9), PronySeries(1e4, {{0.02, 0.5e6}})};
  const auto warnings = responder.with({{"binder", other}}).respond().front().warnings;
  EXPECT_THAT(warnings, is_softer_than("other"));
  EXPECT_THAT(warnings, Not(is_softer_than("binder")));
}

// The stages of both have one name and one grid.
TEST(ResponsesOf, AResultOfAnotherStudyIsRefused) {
  auto study = small_study(6e-3);
  const auto result = solve(study);
  EXPECT_THAT(responses_of(study, result), SizeIs(1));
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(responses_of(small_study(5e-3), result)); }),
              HasSubstr("the result is of another study"));
  study.stages[0].fillers[0].material.density = 1.0;
  EXPECT_THROW(static_cast<void>(responses_of(study, result)), InputError);
}

TEST(ResponsesOf, AResultOfAnotherStageOrGridIsRefused) {
  const auto study = small_study(6e-3);
  auto stage = study.stages[0];
  StageResult result;
  result.name = "elsewhere";
  result.cells = stage.cells;
  EXPECT_THROW(static_cast<void>(responses_of(study, stage, result)), InputError);
  result.name = stage.name;
  result.cells = 2 * stage.cells;
  EXPECT_THROW(static_cast<void>(responses_of(study, stage, result)), InputError);
}

TEST(Respond, ResponsesOfTwoStudiesInTheMemoryAreNotMixed) {
  const auto one = small_study(6e-3);
  auto other = small_study(5e-3);
  other.stages[0].name = "coarse";
  auto responses = responses_of(one, solve(one));
  responses.push_back(responses_of(other, solve(other)).front());
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(Responder(responses)); }),
              HasSubstr("of different studies"));
}

TEST(Respond, StagesThatBuildOnThemselvesAreRefused) {
  StageResponses one, other;
  one.stage = "one";
  one.matrix = EarlierStage{"other"};
  other.stage = "other";
  other.matrix = EarlierStage{"one"};
  EXPECT_THAT(test::message_of<InputError>([&] {
                static_cast<void>(Responder({one, other}));
              }),
              HasSubstr("the responses of stage one build on themselves"));
  one.matrix = EarlierStage{"one"};
  EXPECT_THROW(static_cast<void>(Responder({one})), InputError);
}

TEST(Respond, AMaterialIsShownByItsOwnNameAndTemperature) {
  StageResponses stage;
  stage.stage = "A";
  stage.matrix = test::binder;
  const auto other = Responder({stage}).with({{"binder",
                                               {"other", 1e3, PronySeries(1e9), PronySeries(1e5, {{1.0, 1e6}})},
                                               {{WilliamsLandelFerry{8.0, 100.0, 293.15}, 293.15}}}});
  EXPECT_THAT(other.shown_names(), ElementsAre("other"));
  EXPECT_THAT(other.at(313.15).shown_names(), ElementsAre("other at 40 degC"));
  EXPECT_THAT(other.at(313.15).at(323.15).shown_names(), ElementsAre("other at 50 degC"));
}

TEST(Respond, AStageWithoutResponsesIsRefused) {
  StageResponses empty;
  empty.stage = "A";
  empty.matrix = test::binder;
  empty.times = {1e-3, 1.0};
  EXPECT_EQ(test::message_of<InputError>([&] { static_cast<void>(Responder({empty}).respond()); }),
            "stage A has no reduced response");
}

}  // namespace
}  // namespace breccia

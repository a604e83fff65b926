#include "breccia/homogenisation/respond.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/solve.hpp"

#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::IsEmpty;
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
  const auto answered = respond(responses, test::binder);
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
  const auto warm = respond(stored, shifted(test::binder, factor));
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

TEST(ResponsesOf, AResultOfAnotherStudyIsRefused) {
  const auto study = test::two_stages();
  StudyResult result;
  result.stages.emplace_back().name = "elsewhere";
  EXPECT_THROW(static_cast<void>(responses_of(study, result)), InputError);
}

}  // namespace
}  // namespace breccia

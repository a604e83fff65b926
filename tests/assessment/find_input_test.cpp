#include "breccia/assessment/find_input.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

using testing::SizeIs;

/// Two inputs: a with ends, b without.
std::vector<UncertainInput> one_with_ends() {
  return {{"a", "Pa", Distribution(Uniform{1e9, 3e9})}, {"b", "", Distribution(Normal{0.0, 1.0})}};
}

AssessmentDesign samples_of(const std::vector<UncertainInput>& inputs) {
  return design_samples(inputs, {false, false}, {.samples = 400});
}

/// One curve at two times, of which ln G is a function of a [GPa] and the score of b.
std::vector<SampledCurve> one_curve(const std::vector<UncertainInput>& inputs, const AssessmentDesign& design,
                                    const std::function<double(double, double)>& logarithm) {
  SampledCurve curve = {.name = "G", .unit = "Pa", .at = {1e-3, 1e-1}, .reference = {1.0, 1.0}, .errors = {{}, {}}};
  curve.values = Eigen::MatrixXd(2, design.coordinates.cols());
  for (Eigen::Index i = 0; i < design.coordinates.cols(); ++i) {
    const double a = value_at_score(std::get<Distribution>(inputs[0].known), design.coordinates(0, i)) / 1e9;
    curve.values.col(i).setConstant(std::exp(logarithm(a, design.coordinates(1, i))));
  }
  return {curve};
}

FoundInput found_for(double wanted, double model_deviation, const std::function<double(double, double)>& logarithm,
                     std::size_t sought = 0) {
  const auto inputs = one_with_ends();
  const auto design = samples_of(inputs);
  const Observation observation = {.curve = ObservedCurve::relaxation, .at = 1e-2, .value = wanted};
  return find_input(inputs, sought, design, one_curve(inputs, design, logarithm), observation, model_deviation);
}

double in_gpa(double score) {
  return value_at_score(Uniform{1.0, 3.0}, score);
}

TEST(FindInput, FindsTheRootAndWhatOtherInputsLeaveOpen) {
  // ln G = a + 0.1 b: with G = e^2 the input is 2 - 0.1 b.
  const auto found = found_for(std::exp(2.0), 0.0, [](double a, double b) { return a + 0.1 * b; });
  ASSERT_THAT(found.scores, SizeIs(1));
  EXPECT_NEAR(in_gpa(found.scores.front()), 2.0, 1e-6);
  EXPECT_NEAR(in_gpa(found.lower), 2.0 - 0.196, 0.005);
  EXPECT_NEAR(in_gpa(found.upper), 2.0 + 0.196, 0.005);
  EXPECT_NEAR(found.points.front().input / 1e9, 1.0, 1e-3);
  EXPECT_NEAR(found.points.back().input / 1e9, 3.0, 1e-3);
  EXPECT_NEAR(found.points.front().value, std::exp(1.0), 0.01);
  EXPECT_NEAR(found.points.front().interval.upper / std::exp(1.196), 1.0, 0.01);
}

TEST(FindInput, CountsTheErrorOfTheModel) {
  // A falling modulus, and a factor whose logarithm has the deviation ln 1.2 beside that of b.
  const auto found = found_for(std::exp(-2.0), 0.2, [](double a, double b) { return -a + 0.1 * b; });
  const double half = 1.96 * std::hypot(0.1, std::log(1.2));
  EXPECT_NEAR(in_gpa(found.lower), 2.0 - half, 0.01);
  EXPECT_NEAR(in_gpa(found.upper), 2.0 + half, 0.01);
}

TEST(FindInput, SaysWhereAnEndIsBeyondTheRange) {
  const auto found = found_for(std::exp(2.9), 0.0, [](double a, double b) { return a + 0.1 * b; });
  ASSERT_THAT(found.scores, SizeIs(1));
  EXPECT_NEAR(in_gpa(found.lower), 2.9 - 0.196, 0.005);
  EXPECT_TRUE(std::isinf(found.upper) && found.upper > 0.0);
  EXPECT_NEAR(found.without, 0.159, 0.01) << "one standard deviation of b";
  const auto falling = found_for(std::exp(-1.1), 0.0, [](double a, double b) { return -a + 0.1 * b; });
  EXPECT_TRUE(std::isinf(falling.lower) && falling.lower < 0.0);
  EXPECT_NEAR(in_gpa(falling.upper), 1.1 + 0.196, 0.005);
  EXPECT_THAT(found_for(std::exp(3.2), 0.0, [](double a, double b) { return a + 0.1 * b; }).scores, SizeIs(0));
}

TEST(FindInput, FindsEachOfSeveralValues) {
  const auto found =
      found_for(std::exp(0.25), 0.0, [](double a, double b) { return (a - 2.0) * (a - 2.0) + 0.01 * b; });
  ASSERT_THAT(found.scores, SizeIs(2));
  EXPECT_NEAR(in_gpa(found.scores[0]), 1.5, 1e-5);
  EXPECT_NEAR(in_gpa(found.scores[1]), 2.5, 1e-5);
}

TEST(FindInput, SearchesADistributionWithoutEndsWhereItWasSampled) {
  const auto logarithm = [](double a, double b) { return 0.01 * a + b; };
  const auto found = found_for(std::exp(0.02 + 1.0), 0.0, logarithm, 1);
  ASSERT_THAT(found.scores, SizeIs(1));
  EXPECT_NEAR(found.scores.front(), 1.0, 1e-6);
  EXPECT_GT(found.points.back().input, 2.5);
  EXPECT_LT(found.points.back().input, 3.5);
  EXPECT_TRUE(std::ranges::is_sorted(found.points, {}, &DesignPoint::input));
}

TEST(FindInput, CasesWithoutARootAreBeyondTheEndThatIsNearer) {
  // ln G = a - b^2 reaches 2.9 with the median of b, and with most other values of it only beyond a = 3.
  const auto found = found_for(std::exp(2.9), 0.0, [](double a, double b) { return a - b * b; });
  ASSERT_THAT(found.scores, SizeIs(1));
  EXPECT_GT(found.without, 0.7);
  EXPECT_GT(found.lower, 0.0);
  EXPECT_TRUE(std::isinf(found.upper) && found.upper > 0.0);
}

TEST(FindInput, FindsAPhase) {
  const auto inputs = one_with_ends();
  const auto design = samples_of(inputs);
  std::vector<SampledCurve> curves(2);
  curves[0] = {.name = "|G*|", .unit = "Pa", .curve = ObservedCurve::absolute, .at = {1.0, 10.0}};
  curves[1] = {.name = "phase of G*", .unit = "rad", .curve = ObservedCurve::phase, .at = {1.0, 10.0}};
  for (auto& curve : curves) curve.values = Eigen::MatrixXd(2, design.coordinates.cols());
  for (Eigen::Index i = 0; i < design.coordinates.cols(); ++i) {
    const double a = value_at_score(std::get<Distribution>(inputs[0].known), design.coordinates(0, i)) / 1e9;
    curves[0].values.col(i).setConstant(1e6);
    curves[1].values.col(i).setConstant(0.3 + 0.1 * a + 0.01 * design.coordinates(1, i));
  }
  const auto found =
      find_input(inputs, 0, design, curves, {.curve = ObservedCurve::phase, .at = 3.0, .value = 0.5}, 0.05);
  ASSERT_THAT(found.scores, SizeIs(1));
  EXPECT_NEAR(in_gpa(found.scores.front()), 2.0, 1e-6);
  EXPECT_NEAR(in_gpa(found.upper) - in_gpa(found.lower), 2.0 * 0.196, 0.01) << "an error of the modulus is none of it";
}

}  // namespace
}  // namespace breccia

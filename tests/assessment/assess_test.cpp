#include "breccia/assessment/assess.hpp"

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/sampled_curves.hpp"
#include "filled_binder.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<UncertainInput> two_inputs() {
  return {{"materials.binder.factors.modulus", "", Distribution(LogNormal{1.0, 1.2})},
          {"stages.box.filler.0.fraction", "", Distribution(Normal{0.5, 0.01})}};
}

/// A curve of two values: both inputs in the first, the first alone in the second.
SampledCurve curve_of(const AssessmentDesign& design, double scatter_of_boxes = 0.0) {
  const auto samples = design.coordinates.cols();
  SampledCurve curve = {.name = "G",
                        .unit = "Pa",
                        .at = {1e-3, 1.0},
                        .values = Eigen::MatrixXd(2, samples),
                        .reference = {1e6, 1e5},
                        .errors = {0.05, std::nullopt}};
  for (Eigen::Index i = 0; i < samples; ++i) {
    const double own = design.box_of[static_cast<std::size_t>(i)] % 2 == 0 ? scatter_of_boxes : -scatter_of_boxes;
    curve.values(0, i) = 1e6 * std::exp(0.2 * design.coordinates(0, i) + 0.1 * design.coordinates(1, i) + own);
    curve.values(1, i) = 1e5 * std::exp(0.3 * design.coordinates(0, i));
  }
  return curve;
}

TEST(Assess, FindsBandsAndShares) {
  const auto design = design_samples(two_inputs(), {false, true}, {});
  const auto found = assess(two_inputs(), design, {curve_of(design)});
  ASSERT_THAT(found.curves, SizeIs(1));
  const auto& curve = found.curves.front();
  const double deviation = std::hypot(0.2, 0.1), half = 1.96 * deviation;
  EXPECT_NEAR(curve.median[0] / 1e6, 1.0, 0.005);
  EXPECT_NEAR(std::log(curve.of_inputs[0].upper / 1e6), half, 0.01);
  EXPECT_NEAR(std::log(curve.of_inputs[0].lower / 1e6), -half, 0.01);
  ASSERT_TRUE(curve.whole[0].has_value());
  EXPECT_NEAR(std::log(curve.whole[0]->upper / 1e6), std::hypot(half, std::log(1.05)), 0.01);
  EXPECT_FALSE(curve.whole[1].has_value());
  EXPECT_NEAR(curve.alone(0, 0), 0.8, 0.01);
  EXPECT_NEAR(curve.total(1, 0), 0.2, 0.01);
  EXPECT_NEAR(curve.alone(0, 1), 1.0, 1e-6);
  EXPECT_NEAR(curve.unexplained[0], 0.0, 1e-6);
  EXPECT_THAT(found.warnings, IsEmpty());
  EXPECT_EQ(found.boxes, 10U);
}

TEST(Assess, SaysWhatBoxesScatter) {
  const auto design = design_samples(two_inputs(), {false, true}, {});
  const auto found = assess(two_inputs(), design, {curve_of(design, 0.3)});
  EXPECT_GT(found.curves.front().unexplained[0], 0.4);
  ASSERT_THAT(found.warnings, SizeIs(1));
  EXPECT_THAT(found.warnings.front(), HasSubstr("G: polynomials in the inputs do not predict"));
}

TEST(Assess, DesignsBoxesAndSamples) {
  const auto inputs = two_inputs();
  const auto one_box = design_samples(inputs, {false, false}, {.samples = 200});
  EXPECT_EQ(one_box.boxes.cols(), 1);
  EXPECT_EQ(one_box.coordinates.cols(), 200);
  const auto boxes_alone = design_samples(inputs, {true, true}, {.samples = 200});
  EXPECT_EQ(boxes_alone.boxes.cols(), 12) << "twice the polynomials of degree 2 in two inputs";
  EXPECT_EQ(boxes_alone.coordinates, boxes_alone.boxes) << "a box has one sample";
  const auto asked = design_samples(inputs, {false, true}, {.samples = 100, .boxes = 30});
  EXPECT_EQ(asked.boxes.cols(), 30);
  EXPECT_EQ(asked.coordinates.cols(), 120) << "as many samples in every box";
  for (Eigen::Index i = 0; i < asked.coordinates.cols(); ++i) {
    EXPECT_EQ(asked.coordinates(1, i),
              asked.boxes(1, static_cast<Eigen::Index>(asked.box_of[static_cast<std::size_t>(i)])));
  }
}

TEST(Assess, TakesAllCombinationsOfAFewChoices) {
  const Choices two = {{std::int64_t{1}, std::int64_t{2}}},
                three = {{std::int64_t{1}, std::int64_t{2}, std::int64_t{3}}};
  const auto design = design_samples({{"a", "", two}, {"b", "", three}}, {true, true}, {});
  ASSERT_EQ(design.boxes.cols(), 6);
  std::set<std::pair<double, double>> different;
  for (const auto& box : design.boxes.colwise()) different.insert({box[0], box[1]});
  EXPECT_THAT(different, SizeIs(6));
}

TEST(Assess, FindsTheSharesOfChoicesOfBoxes) {
  // Every box that there is was solved: polynomials take each of them as it is.
  const Choices two = {{std::int64_t{1}, std::int64_t{2}}},
                three = {{std::int64_t{1}, std::int64_t{2}, std::int64_t{3}}};
  const std::vector<UncertainInput> inputs = {{"a", "", two}, {"b", "", three}};
  const auto design = design_samples(inputs, {true, true}, {});
  const std::vector<double> of_b = {-0.3, 0.1, 0.2};
  SampledCurve curve = {.name = "G", .unit = "Pa", .at = {1.0}};
  curve.values = Eigen::MatrixXd(1, design.coordinates.cols());
  curve.reference = {1e6};
  curve.errors = {std::nullopt};
  for (Eigen::Index i = 0; i < design.coordinates.cols(); ++i) {
    const double a = design.coordinates(0, i) == 0.0 ? -0.2 : 0.2;
    curve.values(0, i) = 1e6 * std::exp(a + of_b[static_cast<std::size_t>(design.coordinates(1, i))]);
  }
  const auto found = assess(inputs, design, {curve});
  const double of_a = 0.04, variance_of_b = (0.09 + 0.01 + 0.04) / 3.0;
  EXPECT_NEAR(found.curves.front().alone(0, 0), of_a / (of_a + variance_of_b), 1e-9);
  EXPECT_NEAR(found.curves.front().alone(1, 0), variance_of_b / (of_a + variance_of_b), 1e-9);
  EXPECT_NEAR(interactions_of(found.curves.front())[0], 0.0, 1e-9);
  EXPECT_NEAR(found.curves.front().of_inputs[0].upper / 1e6, std::exp(0.4), 1e-9);
}

TEST(Assess, TakesManyInputsWithoutMemoryForAllTheirPolynomials) {
  std::vector<UncertainInput> inputs(20);
  for (auto& input : inputs) input.known = Distribution(Normal{0.0, 1.0});
  const auto design = design_samples(inputs, std::vector<bool>(inputs.size(), false), {.samples = 200});
  SampledCurve curve = {.name = "G", .unit = "Pa", .at = {1.0}};
  curve.values = Eigen::MatrixXd(1, design.coordinates.cols());
  curve.reference = {1.0};
  curve.errors = {std::nullopt};
  for (Eigen::Index i = 0; i < design.coordinates.cols(); ++i)
    curve.values(0, i) = std::exp(0.1 * design.coordinates(7, i));
  EXPECT_NEAR(assess(inputs, design, {curve}).curves.front().alone(7, 0), 1.0, 1e-9);
}

TEST(Assess, NothingThatVariesHasNoInteractions) {
  AssessedCurve curve;
  curve.alone = curve.total = Eigen::MatrixXd::Zero(2, 1);
  EXPECT_EQ(interactions_of(curve), std::vector{0.0});
}

TEST(Assess, SamplesTheCurvesOfASolvedStage) {
  // The moduli of the binder times a factor that all materials share change G by the same factor.
  const auto& composite = test::filled_binder();
  const auto results = composite.responder.respond();
  const StageFindings& reference = results.front();
  auto binder = test::four_terms().material, glass = test::glass;
  const double factor = 1.1;
  binder.shear = binder.shear.scaled(factor);
  binder.bulk = binder.bulk.scaled(factor);
  glass.shear = glass.shear.scaled(factor);
  glass.bulk = glass.bulk.scaled(factor);
  SampledStage stage = {.reference = reference,
                        .boxes = {composite.responder},
                        .box_of = {0, 0},
                        .materials = {{}, {new_material("binder", {binder}), new_material("glass", {glass})}}};
  const auto curves = sample_curves(stage);
  ASSERT_THAT(curves, SizeIs(2));
  EXPECT_EQ(curves[0].name, "G");
  EXPECT_EQ(curves[1].name, "K + G/3");
  for (const auto& curve : curves) {
    for (std::size_t i = 0; i < curve.at.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      EXPECT_NEAR(curve.values(row, 0) / curve.reference[i], 1.0, 1e-12);
      EXPECT_NEAR(curve.values(row, 1) / curve.reference[i], factor, 1e-3);
    }
  }
  stage.threads = 1;
  EXPECT_EQ(sample_curves(stage).front().values, curves.front().values) << "as with several threads";
}

}  // namespace
}  // namespace breccia

#include "assessment/polynomial_model.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/assessment/calibrate_inputs.hpp"
#include "breccia/error.hpp"

#include "messages.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

std::vector<UncertainInput> two_inputs() {
  return {{"a", "Pa", Distribution(LogNormal{5e9, 1.2})}, {"b", "", Distribution(Normal{0.5, 0.05})}};
}

AssessmentDesign design_of(const std::vector<UncertainInput>& inputs) {
  return design_samples(inputs, {false, false}, {.samples = 200});
}

/// G and K + G/3 at three times, log-linear in both scores.
std::vector<SampledCurve> two_curves(const AssessmentDesign& design) {
  std::vector<SampledCurve> curves(2);
  curves[0] = {.name = "G", .unit = "Pa"};
  curves[1] = {.name = "K + G/3", .unit = "Pa", .modulus = ObservedModulus::bulk, .share_of_shear = 1.0 / 3.0};
  for (auto& curve : curves) {
    const bool is_bulk = curve.modulus == ObservedModulus::bulk;
    curve.at = {1e-3, 1e-2, 1e-1};
    curve.values = Eigen::MatrixXd(3, design.coordinates.cols());
    curve.reference = {1e8, 1e7, 1e6};
    curve.errors = {0.02, 0.02, 0.02};
    for (Eigen::Index i = 0; i < design.coordinates.cols(); ++i) {
      const double a = design.coordinates(0, i), b = design.coordinates(1, i);
      for (Eigen::Index t = 0; t < 3; ++t) {
        const double shear =
            std::pow(10.0, 8.0 - static_cast<double>(t)) * std::exp(0.2 * a + 0.1 * static_cast<double>(t) * b);
        curve.values(t, i) = is_bulk ? 1e10 * std::exp(0.3 * b) : shear;
      }
    }
  }
  return curves;
}

Observation observed(ObservedModulus modulus, double at, double value, double deviation = 0.01) {
  return {.modulus = modulus, .curve = ObservedCurve::relaxation, .at = at, .value = value, .deviation = deviation};
}

TEST(PolynomialModel, PredictsGAndK) {
  const auto inputs = two_inputs();
  const auto design = design_of(inputs);
  const PolynomialModel model(
      inputs, design, two_curves(design),
      {observed(ObservedModulus::shear, 1e-2, 1.0), observed(ObservedModulus::bulk, 1e-2, 1.0),
       observed(ObservedModulus::p_wave, 1e-2, 1.0), observed(ObservedModulus::shear, std::sqrt(1e-5), 1.0)},
      0.0);
  ASSERT_THAT(model.components(), SizeIs(2)) << "a model without an error has no factor";
  const Eigen::Vector2d scores(0.5, -1.0);
  const auto values = model.predictions(scores);
  const double shear = 1e7 * std::exp(0.1 - 0.1), tested = 1e10 * std::exp(-0.3);
  EXPECT_NEAR(values[0] / shear, 1.0, 1e-9);
  EXPECT_NEAR(values[1] / (tested - shear / 3.0), 1.0, 1e-9);
  EXPECT_NEAR(values[2] / (tested + shear), 1.0, 1e-9);
  EXPECT_NEAR(values[3] / (std::sqrt(1e15) * std::exp(0.1 - 0.05)), 1.0, 1e-9) << "between two times";
  const auto jacobian = model.jacobian(scores);
  EXPECT_NEAR(jacobian(0, 0), 0.2 / 0.01, 1e-5);
  EXPECT_NEAR(jacobian(0, 1), 0.1 / 0.01, 1e-5);
}

TEST(PolynomialModel, PredictsDynamicModuli) {
  const auto inputs = two_inputs();
  const auto design = design_of(inputs);
  std::vector<SampledCurve> curves(2);
  curves[0] = {.name = "|G*|", .unit = "Pa", .curve = ObservedCurve::absolute, .at = {1.0, 10.0}};
  curves[1] = {.name = "phase of G*", .unit = "rad", .curve = ObservedCurve::phase, .at = {1.0, 10.0}};
  for (auto& curve : curves) curve.values = Eigen::MatrixXd(2, design.coordinates.cols());
  for (Eigen::Index i = 0; i < design.coordinates.cols(); ++i) {
    curves[0].values.col(i).setConstant(1e6 * std::exp(0.2 * design.coordinates(0, i)));
    curves[1].values.col(i).setConstant(0.5 + 0.02 * design.coordinates(1, i));
  }
  std::vector<Observation> observations;
  for (const auto curve :
       {ObservedCurve::storage, ObservedCurve::loss, ObservedCurve::absolute, ObservedCurve::phase}) {
    observations.push_back({.curve = curve, .at = 3.0, .value = 1.0, .deviation = 0.01});
  }
  const PolynomialModel model(inputs, design, curves, observations, 0.0);
  const auto values = model.predictions(Eigen::Vector2d(1.0, 1.0));
  const double absolute = 1e6 * std::exp(0.2);
  EXPECT_NEAR(values[0] / (absolute * std::cos(0.52)), 1.0, 1e-9);
  EXPECT_NEAR(values[1] / (absolute * std::sin(0.52)), 1.0, 1e-9);
  EXPECT_NEAR(values[2] / absolute, 1.0, 1e-9);
  EXPECT_NEAR(values[3], 0.52, 1e-9);
}

TEST(PolynomialModel, RefusesAllMistakesAtOnce) {
  auto inputs = two_inputs();
  inputs[1].known = Choices{{std::int64_t{1}, std::int64_t{2}}};
  const auto design = design_of(two_inputs());
  auto curves = two_curves(design);
  curves.pop_back();
  auto young = observed(ObservedModulus::young, 1e-2, 1.0), warm = observed(ObservedModulus::shear, 1e-2, 1.0);
  warm.temperature = 300.0;
  const auto message = test::message_of<InputError>([&] {
    const PolynomialModel model(inputs, design, curves,
                                {young,
                                 warm,
                                 observed(ObservedModulus::bulk, 1e-2, 1.0),
                                 observed(ObservedModulus::shear, 1.0, 1.0),
                                 {.curve = ObservedCurve::storage, .at = 1.0, .value = 1.0, .deviation = 0.1}},
                                0.0);
  });
  EXPECT_THAT(
      message,
      AllOf(HasSubstr("b: any of several values; expected"),
            HasSubstr("young modulus (relaxation): expected a relaxation modulus in shear or bulk at a time"),
            HasSubstr("measurements at 300 K: expected"), HasSubstr("has no test in bulk (tests.loads)"),
            HasSubstr("outside of the curves of the study, 1 ms to 100 ms"), HasSubstr("shear modulus (storage)")));
}

TEST(CalibrateInputs, FindsTheInputsOfALinearModel) {
  // ln G is linear in both scores, so that the posterior is normal: of one datum of each kind it follows by hand.
  const auto inputs = two_inputs();
  const auto design = design_of(inputs);
  const double deviation = 0.1;
  const auto found = calibrate_inputs(inputs, design, two_curves(design),
                                      {observed(ObservedModulus::shear, 1e-3, 1e8 * std::exp(0.2), deviation)}, 0.0,
                                      {.noise = Noise::known, .samples = 0});
  // Precision of the first score: 1 + (0.2 / 0.1)^2 = 5; its mean is 4/5 of the score that the datum asks for, 1.
  ASSERT_THAT(found.estimates, SizeIs(2));
  EXPECT_NEAR(found.estimates[0].score, 0.8, 1e-3);
  EXPECT_NEAR(found.estimates[0].deviation, std::sqrt(0.2), 1e-3);
  EXPECT_NEAR(found.estimates[0].value, 5e9 * std::pow(1.2, 0.8), 5e6);
  EXPECT_NEAR(found.estimates[1].learned, 0.0, 1e-3) << "G at the first time does not depend on it";
}

TEST(CalibrateInputs, TakesTheErrorOfTheModelAsAFactor) {
  const auto inputs = two_inputs();
  const auto design = design_of(inputs);
  const auto found = calibrate_inputs(inputs, design, two_curves(design),
                                      {observed(ObservedModulus::shear, 1e-3, 1e8 * std::exp(0.2), 1e-4)}, 0.2,
                                      {.noise = Noise::known, .samples = 0});
  ASSERT_THAT(found.estimates, SizeIs(3));
  EXPECT_EQ(found.estimates[2].name, "model");
  // The input and the factor, of 0.2 and ln 1.2 a score, share what the datum asks for by their variances.
  const double of_factor = std::log(1.2), share = 0.04 / (0.04 + of_factor * of_factor);
  EXPECT_NEAR(0.2 * found.estimates[0].score, 0.2 * share, 1e-3);
}

}  // namespace
}  // namespace breccia

#include "assessment/polynomial_chaos.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/latin_hypercube.hpp"

namespace breccia {
namespace {

/// Samples of an output, each of a group of its own.
template <class Function>
SampledOutputs sampled(const std::vector<UncertainInput>& inputs, Eigen::Index count, const Function& function) {
  SampledOutputs samples = {.coordinates = latin_hypercube(inputs, count, 1),
                            .values = Eigen::MatrixXd(1, count),
                            .groups = {},
                            .are_of_group = std::vector<bool>(inputs.size(), false)};
  for (Eigen::Index i = 0; i < count; ++i) {
    samples.values(0, i) = function(Eigen::VectorXd(samples.coordinates.col(i)));
    samples.groups.push_back(static_cast<std::size_t>(i));
  }
  return samples;
}

std::vector<UncertainInput> normal_inputs(std::size_t count) {
  std::vector<UncertainInput> inputs(count);
  for (auto& input : inputs) input.known = Distribution(Normal{0.0, 1.0});
  return inputs;
}

TEST(PolynomialChaos, IsExactForPolynomials) {
  // 1 + 2 a + 3 a b + (b^2 - 1): variances 4, 9 and 2.
  const auto inputs = normal_inputs(2);
  const auto samples = sampled(
      inputs, 60, [](const Eigen::VectorXd& z) { return 1.0 + 2.0 * z[0] + 3.0 * z[0] * z[1] + z[1] * z[1] - 1.0; });
  const PolynomialChaos polynomials(inputs, samples);
  EXPECT_NEAR(polynomials.variances()[0], 15.0, 1e-9);
  EXPECT_NEAR(polynomials.first_order()(0, 0), 4.0 / 15.0, 1e-9);
  EXPECT_NEAR(polynomials.first_order()(1, 0), 2.0 / 15.0, 1e-9);
  EXPECT_NEAR(polynomials.total()(0, 0), 13.0 / 15.0, 1e-9);
  EXPECT_NEAR(polynomials.total()(1, 0), 11.0 / 15.0, 1e-9);
  EXPECT_NEAR(polynomials.mean_square_errors()[0], 0.0, 1e-15);
  Eigen::MatrixXd point(2, 1);
  point << 0.5, -2.0;
  EXPECT_NEAR(polynomials.at(point)(0, 0), 1.0 + 1.0 - 3.0 + 3.0, 1e-9);
}

TEST(PolynomialChaos, FindsTheIndicesOfAProductOfLogNormalNumbers) {
  const auto inputs = normal_inputs(2);
  const double a = 0.4, b = 0.7;
  const auto samples = sampled(inputs, 400, [&](const Eigen::VectorXd& z) { return std::exp(a * z[0] + b * z[1]); });
  const PolynomialChaos polynomials(inputs, samples);
  const double of_a = std::expm1(a * a), of_b = std::expm1(b * b), whole = std::expm1(a * a + b * b);
  EXPECT_NEAR(polynomials.first_order()(0, 0), of_a / whole, 3e-3);
  EXPECT_NEAR(polynomials.first_order()(1, 0), of_b / whole, 3e-3);
  EXPECT_NEAR(polynomials.total()(0, 0), 1.0 - of_b / whole, 3e-3);
}

TEST(PolynomialChaos, FindsTheIndicesOfIshigamisFunction) {
  // Saltelli, Chan and Scott, Sensitivity Analysis: a = 7, b = 0.1.
  std::vector<UncertainInput> inputs(3);
  for (auto& input : inputs) input.known = Distribution(Uniform{-std::numbers::pi, std::numbers::pi});
  const auto samples = sampled(inputs, 1000, [&](const Eigen::VectorXd& z) {
    const auto x = [&](Eigen::Index i) { return std::numbers::pi * (2.0 * normal_share(z[i]) - 1.0); };
    return std::sin(x(0)) + 7.0 * std::pow(std::sin(x(1)), 2) + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
  });
  const PolynomialChaos polynomials(inputs, samples);
  EXPECT_NEAR(polynomials.first_order()(0, 0), 0.314, 0.01);
  EXPECT_NEAR(polynomials.first_order()(1, 0), 0.442, 0.01);
  EXPECT_NEAR(polynomials.first_order()(2, 0), 0.0, 0.005);
  EXPECT_NEAR(polynomials.total()(0, 0), 0.558, 0.01);
  EXPECT_NEAR(polynomials.total()(2, 0), 0.244, 0.01);
}

TEST(PolynomialChaos, ComparesChoices) {
  std::vector<UncertainInput> inputs = normal_inputs(2);
  inputs[1].known = Choices{{std::int64_t{1}, std::int64_t{2}, std::int64_t{3}}};
  const std::vector<double> of_choice = {1.0, 2.0, 6.0};
  const auto samples =
      sampled(inputs, 60, [&](const Eigen::VectorXd& z) { return z[0] + of_choice[static_cast<std::size_t>(z[1])]; });
  const PolynomialChaos polynomials(inputs, samples);
  const double of_choices = (4.0 + 1.0 + 9.0) / 3.0;
  EXPECT_NEAR(polynomials.variances()[0], 1.0 + of_choices, 1e-9);
  EXPECT_NEAR(polynomials.first_order()(1, 0), of_choices / (1.0 + of_choices), 1e-9);
}

TEST(PolynomialChaos, PredictsAGroupFromTheOthers) {
  // An error that all samples of a group share, of which no input knows.
  const auto inputs = normal_inputs(2);
  constexpr Eigen::Index groups = 80, in_a_group = 4;
  const auto boxes = latin_hypercube({inputs[0]}, groups, 3);
  auto samples = sampled(inputs, groups * in_a_group, [](const Eigen::VectorXd& z) { return z[1]; });
  samples.are_of_group = {true, false};
  for (Eigen::Index i = 0; i < samples.values.cols(); ++i) {
    const auto group = i % groups;
    samples.groups[static_cast<std::size_t>(i)] = static_cast<std::size_t>(group);
    samples.coordinates(0, i) = boxes(0, group);
    const double error = group % 2 == 0 ? 0.3 : -0.3;
    samples.values(0, i) += 0.5 * boxes(0, group) + error;
  }
  const PolynomialChaos polynomials(inputs, samples);
  EXPECT_NEAR(polynomials.total()(1, 0), 1.0 / 1.25, 0.05);
  EXPECT_NEAR(std::sqrt(polynomials.mean_square_errors()[0]), 0.3, 0.06) << "the error, not that within a group";
}

TEST(PolynomialChaos, AConstantHasNoShares) {
  const auto inputs = normal_inputs(1);
  const PolynomialChaos polynomials(inputs, sampled(inputs, 20, [](const Eigen::VectorXd&) { return 3.0; }));
  EXPECT_EQ(polynomials.first_order()(0, 0), 0.0);
  EXPECT_EQ(polynomials.total()(0, 0), 0.0);
}

}  // namespace
}  // namespace breccia

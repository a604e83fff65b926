#include "assessment/gaussian_posterior.hpp"

#include <cmath>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace breccia {
namespace {

/// A linear problem A x = b with deviations of one.
InverseProblem linear(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const Eigen::MatrixXd& curvature) {
  return {.observations = b.size(),
          .deviations = [a, b](const Eigen::VectorXd& x) -> Eigen::VectorXd { return a * x - b; },
          .jacobian = [a](const Eigen::VectorXd& /*x*/) { return a; },
          .prior_deviations = Eigen::VectorXd::Ones(a.cols()),
          .curvature = curvature};
}

Eigen::MatrixXd no_curvature(Eigen::Index unknowns) {
  return Eigen::MatrixXd::Zero(0, unknowns);
}

TEST(GaussianPosterior, OfALinearProblemIsExact) {
  Eigen::MatrixXd a(4, 2);
  a << 1.0, 2.0, 0.5, -1.0, 3.0, 0.0, 0.0, 1.0;
  const Eigen::Vector4d b(1.0, 0.3, 2.0, -0.5);
  const auto found = find_posterior(linear(a, b, no_curvature(2)), Noise::known);
  const Eigen::Matrix2d precision = a.transpose() * a + Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d covariance = precision.inverse();
  EXPECT_LT((found.mode - covariance * a.transpose() * b).norm(), 1e-6);
  EXPECT_LT((found.covariance - covariance).norm(), 1e-12);
  EXPECT_NEAR(found.determined, 2.0 - covariance.trace(), 1e-12);
  EXPECT_EQ(found.noise, 1.0);
  EXPECT_TRUE(found.has_converged);
}

// Forty repeated measurements of one number with a deviation of 0.3: the noise is the standard deviation of the sample,
// to the share of the one unknown that they determine.
TEST(GaussianPosterior, FindsTheNoise) {
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal(0.2, 0.3);
  Eigen::VectorXd b(40);
  for (auto& one : b) one = normal(engine);
  const auto found = find_posterior(linear(Eigen::VectorXd::Ones(40), b, no_curvature(1)), Noise::relative);
  const double sample = std::sqrt((b.array() - b.mean()).square().sum() / 39.0);
  EXPECT_NEAR(found.noise / sample, 1.0, 2e-3);
  EXPECT_NEAR(found.covariance(0, 0), sample * sample / 40.0, 1e-4);
}

/// Second differences of n numbers.
Eigen::MatrixXd second_differences(Eigen::Index n) {
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(n - 2, n);
  for (Eigen::Index i = 0; i < n - 2; ++i) c.row(i).segment<3>(i) << 1.0, -2.0, 1.0;
  return c;
}

// Second differences that are drawn with a deviation are found to have it, within the scatter of 198 draws.
TEST(GaussianPosterior, FindsTheDeviationOfTheCurvature) {
  constexpr Eigen::Index n = 200;
  constexpr double deviation = 2e-3;
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal;
  Eigen::VectorXd truth = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 2; i < n; ++i) truth[i] = 2.0 * truth[i - 1] - truth[i - 2] + deviation * normal(engine);
  constexpr double noise = 1e-4;
  Eigen::VectorXd b = truth;
  for (auto& one : b) one += noise * normal(engine);
  const auto found =
      find_posterior(linear(Eigen::MatrixXd::Identity(n, n) / noise, b / noise, second_differences(n)), Noise::known);
  EXPECT_NEAR(std::sqrt(1.0 / found.curvature_weight) / deviation, 1.0, 0.15);
  EXPECT_TRUE(found.has_converged);
}

TEST(GaussianPosterior, OfNoDataKeepsTheWeightOfTheCurvature) {
  const auto found = find_posterior(
      linear(Eigen::MatrixXd::Zero(1, 4), Eigen::VectorXd::Ones(1), second_differences(4)), Noise::known);
  EXPECT_TRUE(found.mode.isZero());
  EXPECT_EQ(found.curvature_weight, 1.0);
}

TEST(GaussianPosterior, TakesTheDeviationsOfThePrior) {
  auto problem = linear(Eigen::MatrixXd::Identity(1, 1), Eigen::VectorXd::Ones(1), no_curvature(1));
  problem.prior_deviations[0] = 3.0;
  const auto found = find_posterior(problem, Noise::known);
  EXPECT_NEAR(found.covariance(0, 0), 1.0 / (1.0 + 1.0 / 9.0), 1e-12);
  EXPECT_NEAR(found.prior_variances[0], 9.0, 1e-12);
}

TEST(GaussianPosterior, OfWhatTheDataDoNotReachIsThePrior) {
  Eigen::MatrixXd a(1, 2);
  a << 100.0, 0.0;
  const auto found = find_posterior(linear(a, Eigen::VectorXd::Constant(1, 50.0), no_curvature(2)), Noise::known);
  EXPECT_NEAR(found.mode[1], 0.0, 1e-9);
  EXPECT_NEAR(found.covariance(1, 1), 1.0, 1e-12);
  EXPECT_NEAR(found.determined, 1.0, 1e-3);
}

}  // namespace
}  // namespace breccia

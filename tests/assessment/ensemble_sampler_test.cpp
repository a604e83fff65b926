#include "assessment/ensemble_sampler.hpp"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace breccia {
namespace {

constexpr EnsembleOptions options = {.walkers = 40, .steps = 2000, .burn_in = 500};

// The standard errors of the moments are those of the independent samples, some 2000.
TEST(EnsembleSampler, HasTheMomentsOfANormalDistribution) {
  const Eigen::Vector2d mean(1.0, -2.0);
  Eigen::Matrix2d covariance;
  covariance << 2.0, 0.9, 0.9, 0.5;
  const Eigen::Matrix2d precision = covariance.inverse();
  const auto log_density = [&](const Eigen::VectorXd& x) -> double {
    return -0.5 * (x - mean).dot(precision * (x - mean));
  };
  const auto found = sample_density(log_density, Eigen::Vector2d::Zero(), Eigen::Matrix2d::Identity(), options);
  EXPECT_GT(found.accepted, 0.5);
  EXPECT_GT(found.independent_samples, 1000.0);
  EXPECT_LT(found.independent_samples, 8000.0) << "the moves of the sampler are no independent draws";
  const Eigen::Vector2d mean_found = found.samples.rowwise().mean();
  EXPECT_LT((mean_found - mean).norm(), 0.1);
  const Eigen::MatrixXd centred = found.samples.colwise() - mean_found;
  const Eigen::Matrix2d covariance_found = centred * centred.transpose() / static_cast<double>(centred.cols());
  EXPECT_LT((covariance_found - covariance).norm() / covariance.norm(), 0.1);
}

// exp(-x^4 / 4) has the second moment 2 Gamma(3/4) / Gamma(1/4) and the fourth moment 1.
TEST(EnsembleSampler, HasTheMomentsOfAnotherDistribution) {
  const auto log_density = [](const Eigen::VectorXd& x) -> double { return -0.25 * std::pow(x[0], 4); };
  const auto found = sample_density(log_density, Eigen::VectorXd::Zero(1), Eigen::MatrixXd::Identity(1, 1), options);
  EXPECT_NEAR(found.samples.row(0).array().square().mean(), 2.0 * std::tgamma(0.75) / std::tgamma(0.25), 0.03);
  EXPECT_NEAR(found.samples.row(0).array().pow(4).mean(), 1.0, 0.06);
}

// Of 14 unknowns 180 steps are too few to tell.
TEST(EnsembleSampler, DoesNotTellTheIndependentSamplesOfAShortChain) {
  const auto log_density = [](const Eigen::VectorXd& x) -> double { return -0.5 * x.squaredNorm(); };
  const auto found = sample_density(log_density, Eigen::VectorXd::Zero(14), Eigen::MatrixXd::Identity(14, 14),
                                    {.walkers = 56, .steps = 180, .burn_in = 90});
  EXPECT_TRUE(std::isnan(found.independent_samples));
}

TEST(EnsembleSampler, RepeatsItself) {
  const auto log_density = [](const Eigen::VectorXd& x) -> double { return -0.5 * x.squaredNorm(); };
  const EnsembleOptions few = {.walkers = 8, .steps = 5, .burn_in = 1};
  const auto draw = [&] {
    return sample_density(log_density, Eigen::VectorXd::Zero(3), Eigen::MatrixXd::Identity(3, 3), few).samples;
  };
  EXPECT_EQ(draw(), draw());
}

}  // namespace
}  // namespace breccia

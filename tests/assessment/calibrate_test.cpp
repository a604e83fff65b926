#include "breccia/assessment/calibrate.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "assessment/observed_model.hpp"
#include "filled_binder.hpp"
#include "messages.hpp"

namespace breccia {
namespace {

/// Values of G(t), five a decade from 3 us to 30 ms, and one of K, of the composite itself with noise.
std::vector<Observation> measured(double noise, unsigned seed) {
  std::vector<Observation> observations;
  for (double t = 3e-6; t < 0.05; t *= std::pow(10.0, 0.2)) {
    observations.push_back({.at = t, .value = 1.0, .deviation = noise});
  }
  observations.push_back({.modulus = ObservedModulus::bulk, .at = 1e-4, .value = 1.0, .deviation = noise});
  const ObservedModel truth({test::filled_binder()}, {}, observations);
  const auto values = truth.predictions(Eigen::VectorXd::Zero(0));
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    observations[i].value = values[static_cast<Eigen::Index>(i)] * std::exp(noise * normal(engine));
  }
  return observations;
}

const std::vector<Unknown> scalars = {UnknownNumber{"glass", MaterialNumber::shear, LogNormal{4e9, 2.0}},
                                      UnknownNumber{"binder", MaterialNumber::times, LogNormal{2.0, 3.0}},
                                      UnknownNumber{"binder", MaterialNumber::modulus, LogNormal{0.7, 2.0}}};

UnknownSpectrum spectrum() {
  return {"binder", {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1}, {1e6, 30.0}};
}

TEST(Calibrate, FindsTheNumbersOfDataWithoutNoise) {
  const auto found = calibrate({test::filled_binder()}, scalars, measured(1e-5, 1), {.noise = Noise::known});
  ASSERT_TRUE(found.has_converged);
  EXPECT_NEAR(found.estimates[0].value / 5e9, 1.0, 0.02) << "the moduli of the glass matter little";
  EXPECT_NEAR(found.estimates[1].value, 1.0, 1e-4);
  EXPECT_NEAR(found.estimates[2].value, 1.0, 1e-4);
  for (const auto& estimate : found.estimates) EXPECT_GT(estimate.learned, 0.99) << estimate.name;
}

TEST(Calibrate, FindsASpectrum) {
  const auto found = calibrate({test::filled_binder()}, {spectrum()}, measured(1e-4, 1), {.noise = Noise::known});
  ASSERT_TRUE(found.has_converged);
  const std::vector<double> truth = {0.0, 10e6, 4e6, 1e6, 0.3e6, 0.0};
  for (std::size_t k = 1; k <= 4; ++k) EXPECT_NEAR(found.estimates[k].value / truth[k], 1.0, 0.05) << k;
  EXPECT_LT(found.estimates[5].value, 3e4) << "the binder has no such term";
}

// 95 % of the intervals hold the truth: of 40 data sets and three numbers, 120 in all, 107 or more with a probability
// of 99 %. Their widths are not larger than they have to be: the values scatter as they say.
TEST(Calibrate, HoldsTheTruthInItsIntervals) {
  int held = 0;
  double squares = 0.0;
  const std::vector<double> truth = {5e9, 1.0, 1.0};
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const auto found = calibrate({test::filled_binder()}, scalars, measured(0.02, seed), {.noise = Noise::relative});
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const auto& [lower, upper] = found.estimates[i].interval;
      held += lower <= truth[i] && truth[i] <= upper ? 1 : 0;
      const auto& estimate = found.estimates[i];
      squares += std::pow((score_of(estimate.prior, truth[i]) - estimate.score) / estimate.deviation, 2) / 120.0;
    }
  }
  EXPECT_GE(held, 107);
  EXPECT_NEAR(squares, 1.0, 0.4);
}

TEST(Calibrate, SaysWhatOnlyThePriorKnows) {
  auto unknowns = scalars;
  unknowns.emplace_back(UnknownNumber{"binder", MaterialNumber::c1, Normal{6.5, 0.5}});
  const auto found = calibrate({test::filled_binder()}, unknowns, measured(0.01, 1), {.noise = Noise::known});
  const auto& estimate = found.estimates.back();
  EXPECT_EQ(estimate.name, "binder.c1");
  EXPECT_NEAR(estimate.learned, 0.0, 1e-9) << "all data are at one temperature";
  EXPECT_NEAR(estimate.value, 6.5, 1e-6);
  EXPECT_NEAR(estimate.deviation, 1.0, 1e-9);
}

TEST(Calibrate, TakesTheErrorOfTheModelAsAnUnknownFactor) {
  auto uncertain = test::filled_binder();
  uncertain.model_deviation = 0.1;
  auto of_shear = measured(0.01, 1);
  of_shear.pop_back();  // K
  const auto exact = calibrate({test::filled_binder()}, scalars, of_shear, {.noise = Noise::known});
  const auto found = calibrate({uncertain}, scalars, of_shear, {.noise = Noise::known});
  EXPECT_EQ(found.estimates.back().name, "model of filled binder");
  EXPECT_GT(found.estimates[2].deviation, 2.0 * exact.estimates[2].deviation)
      << "a factor of the binder's moduli looks the same";
  EXPECT_LT(found.estimates[1].deviation, 1.5 * exact.estimates[1].deviation) << "a factor of its times does not";
}

// Where the data determine the numbers well, the posterior is normal: samples of it say the same, but for the scatter
// of fifty independent ones.
TEST(Calibrate, SamplesWhatTheNormalDistributionSays) {
  const std::vector<Unknown> well_known(scalars.begin() + 1, scalars.end());
  const auto observations = measured(0.02, 5);
  const auto normal = calibrate({test::filled_binder()}, well_known, observations, {.noise = Noise::known});
  const auto sampled =
      calibrate({test::filled_binder()}, well_known, observations, {.noise = Noise::known, .samples = 1200});
  EXPECT_FALSE(normal.independent_samples);
  ASSERT_TRUE(sampled.independent_samples);
  EXPECT_TRUE(std::isnan(*sampled.independent_samples)) << "sixty steps of each walker do not tell";
  for (std::size_t i = 0; i < well_known.size(); ++i) {
    EXPECT_NEAR(sampled.estimates[i].score, normal.estimates[i].score, 0.6 * normal.estimates[i].deviation) << i;
    EXPECT_NEAR(sampled.estimates[i].deviation / normal.estimates[i].deviation, 1.0, 0.4) << i;
  }
  EXPECT_NEAR(sampled.correlation(0, 1), normal.correlation(0, 1), 0.4);
  for (std::size_t i = 0; i < observations.size(); i += 5) {
    const auto width = [i](const Calibration& found) {
      return found.predictions[i].interval.upper - found.predictions[i].interval.lower;
    };
    EXPECT_NEAR(width(sampled) / width(normal), 1.0, 0.5) << i;
  }
}

TEST(Calibrate, RefusesToFindTheNoiseOfTooFewData) {
  const std::vector<Observation> one = {measured(0.02, 1).front()};
  EXPECT_THAT(test::message_of<InputError>([&] {
                static_cast<void>(calibrate({test::filled_binder()}, {scalars[1]}, one, {.noise = Noise::relative}));
              }),
              testing::HasSubstr("too few are left to estimate the noise of the data; state the noise"));
  const auto known = calibrate({test::filled_binder()}, {scalars[1]}, one, {.noise = Noise::known});
  EXPECT_LT(known.estimates[0].deviation, 1.0);
}

TEST(Calibrate, RefusesACompositeWithoutData) {
  EXPECT_THAT(test::message_of<InputError>([] {
                static_cast<void>(calibrate({test::filled_binder(), test::filled_binder()}, scalars, measured(0.02, 1),
                                            {.noise = Noise::known}));
              }),
              testing::HasSubstr("nothing was measured of filled binder"));
}

// The same data twice, as of two composites: the intervals are narrower by the root of two.
TEST(Calibrate, TakesSeveralComposites) {
  const auto once = measured(0.02, 1);
  auto twice = once;
  for (auto observation : once) {
    observation.composite = 1;
    twice.push_back(observation);
  }
  const std::vector<Unknown> two(scalars.begin() + 1, scalars.end());
  const auto one = calibrate({test::filled_binder()}, two, once, {.noise = Noise::known});
  const auto both = calibrate({test::filled_binder(), test::filled_binder()}, two, twice, {.noise = Noise::known});
  for (std::size_t i = 0; i < two.size(); ++i) {
    EXPECT_NEAR(one.estimates[i].deviation / both.estimates[i].deviation, std::sqrt(2.0), 0.02) << i;
  }
}

// A run covers what it has sampled at the times of the data, not only at its own.
TEST(Calibrate, WarnsOfWhatWasNotSampled) {
  const std::vector<Unknown> soft = {UnknownNumber{"glass", MaterialNumber::shear, LogNormal{0.2e9, 1.01}}};
  const auto found = calibrate({test::filled_binder()}, soft, measured(0.02, 1), {.noise = Noise::known});
  ASSERT_EQ(found.warnings.size(), 2U);
  EXPECT_THAT(found.warnings[0], testing::HasSubstr("the materials that were found are outside of what its run has"));
  const std::vector<Unknown> wide = {UnknownNumber{"glass", MaterialNumber::shear, LogNormal{5e9, 5.0}}};
  const auto vague = calibrate({test::filled_binder()}, wide, {measured(0.5, 1).front()}, {.noise = Noise::known});
  EXPECT_THAT(vague.warnings,
              testing::Contains(testing::HasSubstr("the end of its interval, is outside of what its run has sampled")));
  EXPECT_THAT(calibrate({test::filled_binder()}, scalars, measured(0.02, 1), {.noise = Noise::known}).warnings,
              testing::ElementsAre(testing::HasSubstr("the error of its model is not known")));
}

TEST(Calibrate, PredictsWhatItWasGiven) {
  const auto observations = measured(0.02, 5);
  const auto found = calibrate({test::filled_binder()}, scalars, observations, {.noise = Noise::relative});
  ASSERT_EQ(found.predictions.size(), observations.size());
  EXPECT_NEAR(found.noise, 1.0, 0.3);
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const auto& [value, interval, deviation] = found.predictions[i];
    EXPECT_LT(interval.lower, value);
    EXPECT_GT(interval.upper, value);
    EXPECT_NEAR(std::log(observations[i].value / value) / (0.02 * found.noise), deviation, 1e-9);
  }
}

}  // namespace
}  // namespace breccia

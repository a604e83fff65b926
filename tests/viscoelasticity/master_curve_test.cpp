#include "breccia/viscoelasticity/master_curve.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/temperature_shift_fit.hpp"

#include "messages.hpp"
#include "viscoelasticity/binder.hpp"
#include "viscoelasticity/noise.hpp"

namespace breccia {
namespace {

constexpr WilliamsLandelFerry estane = {6.5, 120.0, 292.15};

/// Data of an ideal instrument from 0.1 to 100 rad/s at one temperature.
FrequencySweep sweep_at(double temperature, Noise& noise) {
  FrequencySweep sweep = {.temperature = temperature};
  const double shift = estane.shift_factor(temperature);
  for (int i = 0; i <= 15; ++i) {
    const double omega = std::pow(10.0, -1.0 + 0.2 * i);
    const auto modulus = binder.complex_modulus(shift * omega);
    sweep.frequencies.push_back(omega);
    sweep.storage.push_back(noise(modulus.real()));
    sweep.loss.push_back(noise(modulus.imag()));
  }
  return sweep;
}

/// Sweeps from the glass to the rubber: 232 to 332 K in steps of 10 K.
std::vector<FrequencySweep> sweeps(double scatter) {
  Noise noise(scatter);
  std::vector<FrequencySweep> all;
  for (int difference = -60; difference <= 40; difference += 10) all.push_back(sweep_at(292.15 + difference, noise));
  return all;
}

TEST(MasterCurve, FindsTheShiftsOfNoisySweeps) {
  const auto curve = master_curve(sweeps(0.01), 292.15);
  ASSERT_EQ(curve.shift_factors.size(), 11U);
  double square = 0.0;
  for (const auto& [temperature, log10_factor, standard_error] : curve.shift_factors) {
    const double truth = std::log10(estane.shift_factor(temperature));
    EXPECT_NEAR(log10_factor, truth, 0.03) << temperature;
    EXPECT_LE(standard_error, 0.01);
    if (standard_error > 0.0) square += std::pow((log10_factor - truth) / standard_error, 2);
  }
  // The shifts deviate by about their standard errors, which add up along the chain of sweeps and so are correlated.
  EXPECT_LT(std::sqrt(square / 10.0), 3.0);
  const auto law = fit_williams_landel_ferry(curve.shift_factors, 292.15);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->law.c1, 6.5, 0.1);
  EXPECT_NEAR(law->law.c2, 120.0, 2.0);
}

TEST(MasterCurve, ItsSeriesIsTheBinder) {
  const auto curve = master_curve(sweeps(0.01), 292.15);
  EXPECT_TRUE(std::ranges::is_sorted(curve.frequencies));
  EXPECT_GT(curve.frequencies.back() / curve.frequencies.front(), 1e11);
  EXPECT_NEAR(curve.fit.quality.median_error, 0.0067, 0.002);
  double worst = 0.0;
  const double first = 1.0 / curve.frequencies.back(), last = 1.0 / curve.frequencies.front();
  for (double t = first; t <= last; t *= 1.5) {
    worst = std::max(worst, std::abs(curve.fit.series.at(t) / binder.at(t) - 1.0));
  }
  EXPECT_LT(worst, 0.05);
}

TEST(MasterCurve, ExactSweepsGiveExactShifts) {
  for (const auto& [temperature, log10_factor, standard_error] : master_curve(sweeps(0.0), 292.15).shift_factors) {
    EXPECT_NEAR(log10_factor, std::log10(estane.shift_factor(temperature)), 2e-3) << temperature;
  }
}

TEST(MasterCurve, TheOrderOfTheSweepsDoesNotMatter) {
  auto reversed = sweeps(0.01);
  std::ranges::reverse(reversed);
  const auto curve = master_curve(sweeps(0.01), 272.15), other = master_curve(reversed, 272.15);
  EXPECT_EQ(curve.fit.series, other.fit.series);
  EXPECT_EQ(curve.shift_factors[4].log10_factor, 0.0);
  EXPECT_EQ(curve.shift_factors[4].temperature, 272.15);
}

std::string message(const std::vector<FrequencySweep>& bad, double reference = 292.15) {
  return test::message_of<InputError>([&] { static_cast<void>(master_curve(bad, reference)); });
}

TEST(MasterCurve, RefusesBadSweeps) {
  using testing::HasSubstr;
  const auto good = sweeps(0.0);
  EXPECT_THAT(message(good, 293.15),
              HasSubstr("no sweep at the reference temperature 293.15 K (20 degC); there are 232.15 K (-41 degC), "));
  EXPECT_THAT(message({good[6]}), HasSubstr("two temperatures at least"));
  EXPECT_THAT(message({good[6], good[6]}), HasSubstr("two sweeps at 292.15 K"));
  EXPECT_THAT(message({good[0], good[6]}), HasSubstr("the storage moduli at -41 and 19 degC do not overlap"));
  auto bad = good;
  bad[3].loss[2] = -1.0;
  EXPECT_THAT(message(bad), HasSubstr("the sweep at 262.15 K (-11 degC): expected positive frequencies and moduli"));
  bad = good;
  std::swap(bad[3].frequencies[2], bad[3].frequencies[3]);
  EXPECT_THAT(message(bad), HasSubstr("the sweep at 262.15 K (-11 degC): expected rising frequencies"));
  bad = good;
  bad[3].storage.pop_back();
  EXPECT_THAT(message(bad), HasSubstr("has 16 frequencies, 15 storage and 16 loss moduli"));
}

}  // namespace
}  // namespace breccia

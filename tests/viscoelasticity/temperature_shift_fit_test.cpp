#include "breccia/viscoelasticity/temperature_shift_fit.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "viscoelasticity/estane_shift.hpp"
#include "viscoelasticity/noise.hpp"

namespace breccia {
namespace {

/// log10 a_T of a law at some temperatures from T_ref - 60 K to T_ref + 60 K.
std::vector<ShiftFactor> factors_of(const WilliamsLandelFerry& law) {
  std::vector<ShiftFactor> factors;
  for (int difference = -60; difference <= 60; difference += 10) {
    const double temperature = law.reference_temperature + difference;
    factors.push_back({temperature, std::log10(law.shift_factor(temperature))});
  }
  return factors;
}

TEST(WilliamsLandelFerryFit, FindsTheLawOfExactFactors) {
  const auto fit = fit_williams_landel_ferry(factors_of(estane), estane.reference_temperature);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->law.c1, 6.5, 1e-6);
  EXPECT_NEAR(fit->law.c2, 120.0, 1e-5);
  EXPECT_EQ(fit->law.reference_temperature, 292.15);
  EXPECT_LT(fit->worst_deviation, 1e-8);
}

TEST(WilliamsLandelFerryFit, UniversalConstantsCloseToTheirPole) {
  // c2 = 51.6 K leaves 1.6 K between the coldest sweep and the pole.
  const WilliamsLandelFerry universal = {17.44, 51.6, 373.15};
  std::vector<ShiftFactor> factors;
  for (const double difference : {-50.0, -40.0, -20.0, 0.0, 20.0, 40.0}) {
    factors.push_back({373.15 + difference, -17.44 * difference / (51.6 + difference)});
  }
  const auto fit = fit_williams_landel_ferry(factors, universal.reference_temperature);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->law.c1, 17.44, 1e-4);
  EXPECT_NEAR(fit->law.c2, 51.6, 1e-4);
}

TEST(WilliamsLandelFerryFit, StatedErrorsHoldTheTruth) {
  auto factors = factors_of(estane);
  Noise noise(1.0);
  constexpr double scatter = 0.02;
  for (auto& factor : factors) factor.log10_factor += scatter * (noise(1.0) - 1.0);
  const auto fit = fit_williams_landel_ferry(factors, estane.reference_temperature);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->law.c1, 6.5, 3.0 * fit->c1_error);
  EXPECT_NEAR(fit->law.c2, 120.0, 3.0 * fit->c2_error);
  EXPECT_LT(fit->c1_error, 0.2);
  EXPECT_LT(fit->worst_deviation, 4.0 * scatter);
}

TEST(WilliamsLandelFerryFit, ReturnsNothingForFactorsOfOppositeCurvature) {
  const std::vector<ShiftFactor> factors = {{280.0, 0.9}, {290.0, 0.0}, {300.0, -1.1}, {310.0, -2.4}};
  EXPECT_FALSE(fit_williams_landel_ferry(factors, 290.0));
}

TEST(WilliamsLandelFerryFit, RefusesTooFewAndRisingFactors) {
  const std::vector<ShiftFactor> few = {{290.0, 0.0}, {300.0, -1.0}};
  const std::vector<ShiftFactor> rising = {{280.0, -1.0}, {290.0, 0.0}, {300.0, 1.0}};
  EXPECT_THROW(fit_williams_landel_ferry(few, 290.0), InputError);
  EXPECT_THROW(fit_williams_landel_ferry(rising, 290.0), InputError);
}

TEST(WilliamsLandelFerryFit, CountsTemperaturesAndNotFactors) {
  const std::vector<ShiftFactor> one = {{290.0, 0.0}, {300.0, -1.0}, {300.0, -1.1}, {300.0, -0.9}};
  EXPECT_THROW(fit_williams_landel_ferry(one, 290.0), InputError);
}

}  // namespace
}  // namespace breccia

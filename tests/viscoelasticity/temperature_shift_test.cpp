#include "breccia/viscoelasticity/temperature_shift.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "viscoelasticity/estane_shift.hpp"

namespace breccia {
namespace {

TEST(WilliamsLandelFerry, IsOneAtTheReference) {
  EXPECT_DOUBLE_EQ(estane.shift_factor(292.15), 1.0);
}

TEST(WilliamsLandelFerry, FollowsItsLaw) {
  EXPECT_NEAR(estane.shift_factor(292.15 + 120.0), std::pow(10.0, -3.25), 1e-12);
  EXPECT_NEAR(estane.shift_factor(292.15 - 60.0), std::pow(10.0, 6.5), 1e-3);
}

TEST(WilliamsLandelFerry, EndsAtItsPole) {
  EXPECT_THROW((void)estane.shift_factor(172.0), InputError);
  EXPECT_THROW((void)estane.shift_factor(100.0), InputError);
}

TEST(WilliamsLandelFerry, HasATemperatureForEachFactor) {
  for (const double temperature : {200.0, 292.15, 350.0}) {
    EXPECT_NEAR(estane.temperature_at(std::log10(estane.shift_factor(temperature))), temperature, 1e-9);
  }
  EXPECT_TRUE(std::isinf(estane.temperature_at(-6.5)));
}

// ln a_T = (E_a / R) (1 / T - 1 / T_ref) with 8.31446 J/(mol K).
TEST(Arrhenius, FollowsItsLaw) {
  const auto law = arrhenius(150e3, 293.15);
  for (const double temperature : {233.15, 293.15, 333.15}) {
    EXPECT_NEAR(std::log(law.shift_factor(temperature)), 150e3 / 8.31446261815324 * (1.0 / temperature - 1.0 / 293.15),
                1e-12);
  }
}

}  // namespace
}  // namespace breccia

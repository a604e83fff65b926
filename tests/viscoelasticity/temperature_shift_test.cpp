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

}  // namespace
}  // namespace breccia

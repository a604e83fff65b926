#include "virtual_test/ringing.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace breccia {
namespace {

// Deviations of the model composite from its quasi-static compliance, by the transits of the ramp (theory, section 7).
TEST(Ringing, IsNoLessThanThatOfTheModelComposite) {
  EXPECT_GE(ringing_after_ramp(2.0), 0.14);
  EXPECT_GE(ringing_after_ramp(3.0), 0.019);
  EXPECT_GE(ringing_after_ramp(4.0), 0.010);
  EXPECT_GE(ringing_after_ramp(5.0), 0.0004);
  EXPECT_LT(ringing_after_ramp(5.0), 0.015) << "the ramp by default";
}

TEST(Ringing, IsTheEnvelopeOfTheResponseOfAModeToTheRamp) {
  for (const double transits : {0.1, 0.3, 1.0, 2.2, 3.1, 4.7, 9.0}) {
    const double x = transits / 1.7, angle = std::numbers::pi * x;
    EXPECT_GE(ringing_after_ramp(transits), std::abs(std::sin(angle) / (angle * (1.0 - x * x)))) << transits;
  }
  EXPECT_EQ(ringing_after_ramp(1.0), 1.0);
}

}  // namespace
}  // namespace breccia

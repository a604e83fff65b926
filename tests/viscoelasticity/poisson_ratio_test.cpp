#include "viscoelasticity/poisson_ratio.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace breccia {
namespace {

// K = E / (3 (1 - 2 nu)) and G = E / (2 (1 + nu)).
TEST(PoissonRatio, OfSolidsMadeWithOne) {
  for (const double ratio : {-0.9, -0.2, 0.0, 0.22, 0.35, 0.4999}) {
    constexpr double young = 70e9;
    EXPECT_NEAR(poisson_ratio(young / (3.0 * (1.0 - 2.0 * ratio)), young / (2.0 * (1.0 + ratio))), ratio, 1e-13);
  }
}

TEST(PoissonRatio, OfLimits) {
  EXPECT_EQ(poisson_ratio(1.0, 0.0), 0.5);
  EXPECT_EQ(poisson_ratio(0.0, 1.0), -1.0);
  EXPECT_TRUE(std::isnan(poisson_ratio(0.0, 0.0)));
}

}  // namespace
}  // namespace breccia

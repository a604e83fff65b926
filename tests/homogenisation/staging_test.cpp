#include "homogenisation/staging.hpp"

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

/// A distribution with 30 % of the volume from 1 to 10 um and 70 % from 10 to 100 um.
SizeDistribution sizes() {
  return SizeDistribution::tabulated({1e-6, 10e-6, 100e-6}, {0.0, 0.3, 1.0});
}

// The filler is 80 % with coarse to fine 70:30: 24 of the 44 parts of the fine stage, 56 of the 100 parts of the coarse
// one.
TEST(Staging, OfCoarseAndFine) {
  const auto stages = divide_into_stages(sizes(), {1e-6, 10e-6, 100e-6}, 0.8);
  ASSERT_EQ(stages.size(), 2U);
  EXPECT_NEAR(stages[0].fraction, 24.0 / 44.0, 1e-14);
  EXPECT_NEAR(stages[0].share, 0.3, 1e-14);
  EXPECT_EQ(stages[0].largest, 10e-6);
  EXPECT_NEAR(stages[1].fraction, 0.56, 1e-14);
  EXPECT_EQ(stages[1].smallest, 10e-6);
}

// Each stage reduces the volume fraction of its matrix to 1 - fraction: the product is that of the binder.
TEST(Staging, LeavesTheBinder) {
  double binder = 1.0;
  for (const auto& stage : divide_into_stages(sizes(), {2e-6, 5e-6, 20e-6, 60e-6, 90e-6}, 0.938)) {
    binder *= 1.0 - stage.fraction;
  }
  EXPECT_NEAR(binder, 0.062, 1e-14);
}

TEST(Staging, RefusesInvalidDivisions) {
  EXPECT_THROW(static_cast<void>(divide_into_stages(sizes(), {1e-6, 10e-6}, 1.0)), InputError);
  EXPECT_THROW(static_cast<void>(divide_into_stages(sizes(), {1e-6, 10e-6}, 0.0)), InputError);
  EXPECT_THROW(static_cast<void>(divide_into_stages(sizes(), {10e-6, 1e-6}, 0.5)), InputError);
  EXPECT_THROW(static_cast<void>(divide_into_stages(sizes(), {1e-6, 1e-6}, 0.5)), InputError);
  EXPECT_THROW(static_cast<void>(divide_into_stages(sizes(), {1e-6}, 0.5)), InputError);
  EXPECT_THROW(static_cast<void>(divide_into_stages(sizes(), {1e-6, 100e-6, 200e-6}, 0.5)), InputError) << "nothing";
}

}  // namespace
}  // namespace breccia

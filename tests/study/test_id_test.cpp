#include "breccia/study/test_id.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

TEST(TestGrid, ReadsWhatItWrites) {
  EXPECT_EQ(name_of(TestGrid(150)), "150");
  EXPECT_EQ(name_of(TestGrid::extrapolated()), "extrapolated");
  EXPECT_EQ(grid_named("150"), TestGrid(150));
  EXPECT_EQ(grid_named("extrapolated"), TestGrid::extrapolated());
  for (const auto* name : {"", "0", "-3", "1.5", "12 ", "many", "99999999999"}) {
    EXPECT_EQ(grid_named(name), std::nullopt) << name;
  }
}

TEST(TestGrid, TheLimitIsAboveAllGridsAndHasNoCells) {
  EXPECT_LT(TestGrid(100), TestGrid(200));
  EXPECT_LT(TestGrid(1 << 20), TestGrid::extrapolated());
  EXPECT_EQ(TestGrid(7).cells(), 7);
  EXPECT_EQ(TestGrid::extrapolated().cells(), std::nullopt);
}

TEST(TestId, AQuasistaticLimitIsPreferredToEverythingElse) {
  const TestId limit{.method = Method::quasistatic, .grid = TestGrid::extrapolated()};
  const TestId fine{.method = Method::quasistatic, .grid = TestGrid(200)};
  const TestId coarse{.method = Method::quasistatic, .grid = TestGrid(100)};
  const TestId dynamic{.method = Method::dynamic, .grid = TestGrid::extrapolated()};
  EXPECT_TRUE(is_preferred(limit, fine));
  EXPECT_TRUE(is_preferred(fine, coarse));
  EXPECT_TRUE(is_preferred(coarse, dynamic));
  EXPECT_FALSE(is_preferred(fine, fine));
}

}  // namespace
}  // namespace breccia

#include "breccia/study/test_id.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

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
  EXPECT_LT(TestGrid(std::numeric_limits<int>::max()), TestGrid::extrapolated());
  EXPECT_EQ(TestGrid::extrapolated(), TestGrid::extrapolated());
  EXPECT_NE(TestGrid::extrapolated(), TestGrid(1));
}

TEST(TestGrid, HasACellOrMore) {
  EXPECT_THROW(TestGrid(0), InputError);
  EXPECT_THROW(TestGrid(-1), InputError);
}

// All loads of a quasi-static calculation are computed together.
TEST(TestId, IsPartOfACalculation) {
  const TestId dynamic{Load::bulk, Boundary::traction, Method::dynamic, TestGrid(150)};
  const TestId quasistatic{Load::bulk, Boundary::displacement, Method::quasistatic, TestGrid(150)};
  EXPECT_EQ(calculation_of(dynamic), "bulk, traction, 150 cells, dynamic");
  EXPECT_EQ(calculation_of(quasistatic), "displacement, 150 cells, quasi-static");
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

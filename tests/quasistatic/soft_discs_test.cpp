// Tests of square arrays of discs that are softer than the matrix, against conforming finite elements
// (tests/reference/soft_square_array.csv).

#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

#include "quasistatic/square_array.hpp"

namespace breccia {
namespace {

/// Limits of the errors at an area fraction, with about 12 cells across the disc and with twice as many.
struct Limits {
  double fraction;
  int cells;  ///< cells a side for 12 cells across
  double with_cells, with_twice_the_cells;
};

std::ostream& operator<<(std::ostream& stream, const Limits& limits) {
  return stream << "fraction " << limits.fraction << ", " << limits.cells << " cells";
}

class SoftDiscs : public testing::TestWithParam<Limits> {};

TEST_P(SoftDiscs, AreWithinPercentWithMixedCells) {
  const auto [fraction, cells, with_cells, with_twice_the_cells] = GetParam();
  int arrays = 0;
  for (const auto& array : test::periodic_square_arrays("soft_square_array.csv")) {
    if (array.fraction != fraction) continue;
    EXPECT_LT(std::abs(test::error_of_mixed_cells(array, cells)), with_cells) << array;
    EXPECT_LT(std::abs(test::error_of_mixed_cells(array, 2 * cells)), with_twice_the_cells) << array;
    ++arrays;
  }
  EXPECT_EQ(arrays, 24);
}

INSTANTIATE_TEST_SUITE_P(Fractions, SoftDiscs,
                         testing::Values(Limits{0.2, 24, 0.03, 0.016}, Limits{0.5, 15, 0.04, 0.026}),
                         [](const auto& info) { return info.param.fraction < 0.3 ? "Fifth" : "Half"; });

}  // namespace
}  // namespace breccia

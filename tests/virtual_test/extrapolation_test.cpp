#include "virtual_test/extrapolation.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

Extrapolated extrapolated(const std::vector<double>& sides, const std::vector<double>& values) {
  return extrapolate(sides, values);
}

TEST(Extrapolation, RemovesAnErrorOfFirstOrder) {
  const auto value = [](double h) { return 3.0 + 0.4 * h; };
  const auto two = extrapolated({0.2, 0.1}, {value(0.2), value(0.1)});
  EXPECT_NEAR(two.value, 3.0, 1e-14);
  EXPECT_NEAR(two.half_band, 0.5 * 0.04, 1e-14);
  const auto three = extrapolated({0.3, 0.2, 0.1}, {value(0.3), value(0.2), value(0.1)});
  EXPECT_NEAR(three.value, 3.0, 1e-14);
  // The half band is at least a quarter of the correction, because grids may agree by chance.
  EXPECT_NEAR(three.half_band, 0.25 * 0.04, 1e-14);
}

TEST(Extrapolation, ThreeGridsMeasureTheRemainingError) {
  const auto value = [](double h) { return 3.0 + 0.4 * h + 0.5 * h * h; };
  const auto three = extrapolated({0.4, 0.2, 0.1}, {value(0.4), value(0.2), value(0.1)});
  // The linear function through h and 2h has a limit that is off by -2 h^2 / 2.
  EXPECT_NEAR(three.value, 3.0 - 0.5 * 2.0 * 0.01, 1e-13);
  EXPECT_NEAR(three.half_band, 0.5 * 2.0 * (0.04 - 0.01), 1e-13);
}

TEST(Extrapolation, ModelComposite) {
  // Moduli with averaged points right after the step [MPa] on grids of 100 and 200 cells; the limit is about 0.8746.
  const auto limit = extrapolated({6.0 / 100, 6.0 / 200}, {0.90167, 0.88841});
  EXPECT_NEAR(limit.value, 0.87515, 1e-5);
  EXPECT_LT(std::abs(limit.value - 0.8746), limit.half_band);
}

// The coarser grid differs from the finer one by a tenth, by a quarter, not at all, and by a factor of nine.
TEST(LargestErrors, OfTwiceTheCellsAreTheChangesUpToEachTime) {
  const std::vector coarse = {9.0, 5.0, 2.0, 10.0}, fine = {10.0, 4.0, 2.0, 1.0};
  for (const double ratio : {2.0, 3.0}) {
    const auto errors = largest_errors(coarse, fine, ratio);
    ASSERT_EQ(errors.size(), 4U);
    EXPECT_NEAR(errors[0], 0.1, 1e-15);
    EXPECT_NEAR(errors[1], 0.25, 1e-15);
    EXPECT_NEAR(errors[2], 0.25, 1e-15);
    EXPECT_NEAR(errors[3], 9.0, 1e-14);
  }
  EXPECT_THROW((void)largest_errors(coarse, std::vector{1.0}, 2.0), InputError);
  EXPECT_THROW((void)largest_errors(coarse, fine, 1.0), InputError);
}

// A modulus 100 (1 + h) with cell sides of 0.1 and 0.08: the error of the finer grid is 8 of 108.
TEST(LargestErrors, AreThoseOfFirstOrder) {
  const auto errors = largest_errors(std::vector{110.0}, std::vector{108.0}, 0.1 / 0.08);
  EXPECT_NEAR(errors.at(0), 8.0 / 108.0, 1e-13);
}

TEST(Extrapolation, RefusesOtherNumbersOfGrids) {
  EXPECT_THROW(extrapolated({0.1}, {1.0}), InputError);
  EXPECT_THROW(extrapolated({0.1, 0.2}, {1.0, 1.0}), InputError);
  EXPECT_THROW(extrapolated({0.4, 0.3, 0.2, 0.1}, {1.0, 1.0, 1.0, 1.0}), InputError);
  EXPECT_THROW(extrapolated({0.2, 0.1}, {1.0}), InputError);
}

}  // namespace
}  // namespace breccia

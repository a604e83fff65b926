#include "breccia/homogenisation/grid_estimate.hpp"

#include <array>

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// The largest error of both bounds [-] of boxes like HB-1, between 10 ns and 10 ms, against eight cells in the
/// narrowest gap and more; from docs/verification.md, "Cells in a gap".
struct Measured {
  double cells;
  double of_series;
};

constexpr std::array<Measured, 4> measured = {{{1.5, 0.058}, {2.0, 0.031}, {3.0, 0.014}, {4.0, 0.0083}}};

TEST(GridEstimate, IsOfTheSizeOfMeasuredErrors) {
  for (const auto& [cells, of_series] : measured) {
    const auto expected = expected_grid_error(Mixing::series, cells);
    ASSERT_TRUE(expected);
    EXPECT_GT(*expected, 0.7 * of_series) << cells;
    EXPECT_LT(*expected, 1.3 * of_series) << cells;
  }
}

TEST(GridEstimate, IsUnknownWhereGapsAreBridged) {
  EXPECT_FALSE(expected_grid_error(Mixing::series, 1.49));
  EXPECT_TRUE(expected_grid_error(Mixing::series, 1.5));
  EXPECT_FALSE(expected_grid_error(Mixing::points, 2.9));
  EXPECT_TRUE(expected_grid_error(Mixing::points, 3.0));
}

TEST(GridEstimate, TellsTheCellsForAnError) {
  for (const auto mixing : {Mixing::series, Mixing::points}) {
    for (const double error : {0.04, 0.01, 0.001}) {
      EXPECT_NEAR(expected_grid_error(mixing, cells_per_gap_for(mixing, error)).value(), error, 1e-12);
    }
  }
  EXPECT_EQ(cells_per_gap_for(Mixing::series, 0.5), 1.5) << "below that the error may be of any size";
}

// docs/verification.md, "Thin films": the largest errors at any stiffness of the binder.
TEST(GridEstimate, OfFilmsIsOfTheSizeOfMeasuredErrors) {
  EXPECT_NEAR(expected_film_error(2.4).value(), 0.051, 0.005);
  EXPECT_NEAR(expected_film_error(4.8).value(), 0.022, 0.002);
  EXPECT_FALSE(expected_film_error(2.3)) << "a soft binder cannot be squeezed out";
  for (const double error : {0.05, 0.01})
    EXPECT_NEAR(expected_film_error(cells_per_film_for(error)).value(), error, 1e-12);
  EXPECT_EQ(cells_per_film_for(0.5), 2.4);
}

/// The largest error of the shear modulus [-] of periodic boxes of equal spheres at 40 % between 10 ns and 10 ms, by
/// the cells across a sphere; from docs/verification.md, "Cells across a sphere".
TEST(GridEstimate, OfSpheresIsOfTheSizeOfMeasuredErrors) {
  struct Sphere {
    double cells, error;
  };
  constexpr double fraction = 0.4;
  for (const auto& [cells, error] :
       {Sphere{4.75, 0.158}, Sphere{7.125, 0.087}, Sphere{9.5, 0.052}, Sphere{14.25, 0.026}, Sphere{19.0, 0.016}}) {
    const auto expected = expected_sphere_error(cells, fraction);
    ASSERT_TRUE(expected);
    EXPECT_GT(*expected, 0.9 * error) << cells;
    EXPECT_LT(*expected, 1.1 * error) << cells;
  }
  EXPECT_FALSE(expected_sphere_error(4.4, fraction)) << "too few cells to tell";
  EXPECT_FALSE(expected_sphere_error(19.0, 0.61)) << "close to jamming";
  EXPECT_FALSE(cells_per_diameter_for(0.01, 0.61));
  for (const double share : {0.29, 0.3, 0.4, 0.5}) EXPECT_TRUE(is_sphere_error_measured(share)) << share;
  for (const double extrapolated : {0.0, 0.2, 0.55}) EXPECT_FALSE(is_sphere_error_measured(extrapolated));
  for (const double error : {0.05, 0.01}) {
    EXPECT_NEAR(expected_sphere_error(cells_per_diameter_for(error, 0.5).value(), 0.5).value(), error, 1e-12);
  }
  EXPECT_EQ(cells_per_diameter_for(0.5, fraction), 4.5);
}

}  // namespace
}  // namespace breccia

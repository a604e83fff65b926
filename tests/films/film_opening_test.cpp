// Tests of the openings of films against a layer cut by a wall (tests/reference/film_opening.py), solved by Taylor-Hood
// elements without Breccia.

#include "films/assembly/film_opening.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace breccia::films {
namespace {

/// A film along x, and a wall under an angle [degrees] to it.
FilmOpening opening_at(double angle) {
  const double radians = angle * std::numbers::pi / 180.0;
  return film_opening({1.0, 0.0}, 3.0 * Eigen::Vector2d(std::cos(radians), std::sin(radians)));
}

TEST(FilmOpening, SlipsAndCarriesAsTheLayerDoes) {
  struct Layer {
    double angle, compliance, carried;
  };
  for (const auto& [angle, compliance, carried] : {Layer{30, 0.19903, -0.44515}, Layer{45, 0.15422, -0.29998},
                                                   Layer{60, 0.13050, -0.18654}, Layer{90, 0.11521, 0.00029}}) {
    const auto stiffness = opening_at(angle).stiffness;
    const double sine = std::sin(angle * std::numbers::pi / 180.0);
    // A unit tangential traction does the work 1 / sine on a unit slip of a film of thickness 1.
    EXPECT_NEAR(1.0 / (sine * stiffness(1, 1)), compliance, 1e-3) << angle;
    // The slip without a traction, for a unit flow.
    EXPECT_NEAR(-stiffness(1, 0) / stiffness(1, 1), carried, 1e-3) << angle;
    EXPECT_NEAR(stiffness.determinant(), 0.0, 1e-12);
  }
}

TEST(FilmOpening, DoesNotDependOnTheSenseOfFilmAndWall) {
  const Eigen::Vector2d along(0.6, 0.8), cut(0.2, -0.1);
  const auto one = film_opening(along, cut);
  for (const double of_film : {1.0, -1.0}) {
    for (const double of_wall : {1.0, -1.0}) {
      const auto other = film_opening(of_film * along, of_wall * cut);
      EXPECT_EQ(other.stiffness, one.stiffness);
      EXPECT_EQ(other.slip, of_film * one.slip);
    }
  }
}

}  // namespace
}  // namespace breccia::films

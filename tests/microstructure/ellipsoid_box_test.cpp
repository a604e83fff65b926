#include "breccia/microstructure/ellipsoid_box.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "expect_error.hpp"
#include "microstructure/shapes/ellipsoid_locator.hpp"
#include "random_ellipsoids.hpp"

namespace breccia {
namespace {

using test::expect_error;
using test::random_ellipsoid;
using test::uniform_between;

using std::numbers::pi;
constexpr AxisDirections along_y = {{{0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}}};

/// Two ellipsoids of revolution whose tips face each other across a gap of 2 along x.
EllipsoidBox tips(Walls walls) {
  return {10.0, walls, {{{3.0, 5.0, 5.0}, {4.0, 2.0, 2.0}}, {{8.0, 5.0, 5.0}, {2.0, 4.0, 4.0}}}};
}

/// Ellipsoids of any shape in a periodic box of side 6, each in a part of its own.
EllipsoidBox spread(std::mt19937_64& engine) {
  EllipsoidBox box = {6.0, Walls::periodic};
  for_each_index(Index<3>{}, Index<3>{3, 3, 3}, [&](const Index<3>& part) {
    auto ellipsoid = random_ellipsoid(engine);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ellipsoid.axes[axis] *= 0.9;
      ellipsoid.centre[axis] = 2.0 * part[axis] + uniform_between(engine, 0.0, 0.2);
    }
    box.particles.push_back(ellipsoid);
  });
  return box;
}

/// The smallest gap by comparing all particles with all images of all particles.
double smallest_gap_of_all(const EllipsoidBox& box) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t one = 0; one < box.particles.size(); ++one) {
    for (std::size_t other = 0; other < box.particles.size(); ++other) {
      for_each_index(Index<3>{-1, -1, -1}, Index<3>{2, 2, 2}, [&](const Index<3>& image) {
        if (one == other && image == Index<3>{}) return;
        auto seen = box.particles[other];
        for (std::size_t axis = 0; axis < 3; ++axis) seen.centre[axis] += image[axis] * box.side;
        smallest = std::min(smallest, gap(box.particles[one], seen));
      });
    }
  }
  return smallest;
}

TEST(EllipsoidBox, HasItsStatistics) {
  const auto box = tips(Walls::hard);
  EXPECT_NO_THROW(require_valid(box));
  EXPECT_NEAR(volume_fraction(box), 8.0 * pi / 1000.0, 1e-15);
  EXPECT_NEAR(specific_surface(box), (surface(box.particles[0]) + surface(box.particles[1])) / 1000.0, 1e-15);
  EXPECT_NEAR(smallest_gap(box), 2.0, 1e-14);
  EXPECT_NEAR(smallest_wall_gap(box), 1.0, 1e-14);
  const auto periodic = tips(Walls::periodic);
  EXPECT_NO_THROW(require_valid(periodic));
  EXPECT_NEAR(smallest_gap(periodic), 2.0, 1e-14);
  EXPECT_EQ(smallest_wall_gap(periodic), std::numeric_limits<double>::infinity());
  auto coated = box;
  coated.coatings = {0.5, 0.25};
  EXPECT_NEAR(smallest_gap(coated), 1.25, 1e-14);
  EXPECT_NEAR(smallest_wall_gap(coated), 0.5, 1e-14);
}

TEST(EllipsoidBox, FindsTheSmallestGapAcrossTheSides) {
  std::mt19937_64 engine(3);
  for (int count = 0; count < 3; ++count) {
    const auto box = spread(engine);
    const double smallest = smallest_gap_of_all(box);
    EXPECT_GT(smallest, 0.0);
    EXPECT_NEAR(smallest_gap(box), smallest, 1e-12);
    EXPECT_NO_THROW(require_valid(box));
  }
}

TEST(EllipsoidBox, RefusesWhatCannotBe) {
  auto box = tips(Walls::hard);
  box.particles[0].directions = along_y;
  EXPECT_NO_THROW(require_valid(box));
  box.particles[0].axes[0] = 0.0;
  box.particles[1].centre[2] = 11.0;
  expect_error<InputError>([&] { require_valid(box); }, "particle 1 (ellipsoid of 0 m x 2 m x 2 m", "axes must be",
                           "particle 2", "outside the box");
  box = tips(Walls::hard);
  box.particles[1].centre[1] = 1.5;
  expect_error<InputError>([&] { require_valid(box); }, "particle 2", "crosses a wall by 0.5 m");
  box = tips(Walls::hard);
  box.particles[1].centre[0] = 5.5;
  expect_error<InputError>([&] { require_valid(box); }, "particle 1", "and particle 2", "overlap by 0.5 m");
  box = tips(Walls::periodic);
  box.particles[0].axes[0] = 10.5;
  expect_error<InputError>([&] { require_valid(box); }, "particle 1", "its own periodic image");
  box = tips(Walls::hard);
  box.particles[0].directions[0] = {1.0, 0.1, 0.0};
  expect_error<InputError>([&] { require_valid(box); }, "particle 1", "perpendicular");
}

TEST(EllipsoidLocator, FindsTheNearestParticle) {
  std::mt19937_64 engine(7);
  auto box = spread(engine);
  box.coatings.assign(box.particles.size(), 0.0);
  for (std::size_t k = 0; k < box.coatings.size(); k += 2) box.coatings[k] = 0.02;
  const EllipsoidLocator locator(box);
  int near = 0;
  for (int count = 0; count < 1000; ++count) {
    const Vector<3> point = {uniform_between(engine, 0.0, 6.0), uniform_between(engine, 0.0, 6.0),
                             uniform_between(engine, 0.0, 6.0)};
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < box.particles.size(); ++k) {
      for_each_index(Index<3>{-1, -1, -1}, Index<3>{2, 2, 2}, [&](const Index<3>& image) {
        auto seen = box.particles[k];
        for (std::size_t axis = 0; axis < 3; ++axis) seen.centre[axis] += image[axis] * box.side;
        nearest = std::min(nearest, signed_distance(seen, point) - box.coatings[k]);
      });
    }
    const auto found = locator.at(point);
    if (!found.particle) {
      EXPECT_GE(nearest, found.distance - 1e-12);
      continue;
    }
    ++near;
    EXPECT_NEAR(found.distance - box.coatings[*found.particle], nearest, 1e-12);
  }
  EXPECT_GT(near, 250);
}

}  // namespace
}  // namespace breccia

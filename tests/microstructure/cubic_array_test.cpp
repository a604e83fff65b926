#include "breccia/microstructure/cubic_array.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/statistics.hpp"
#include "breccia/microstructure/validity.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;

using std::numbers::pi;

struct LatticeFacts {
  Lattice lattice;
  std::size_t spheres;   // number of spheres a cell
  double nearest;        // distance of nearest centres over the side of a cell
  std::size_t touching;  // number of nearest neighbours
  double densest;        // fraction of spheres that touch
};

class CubicArray : public ::testing::TestWithParam<LatticeFacts> {};

TEST_P(CubicArray, HasItsNeighboursAndItsDensity) {
  const auto& [lattice, spheres, nearest, touching, densest] = GetParam();
  constexpr int repeats = 3;
  const double side = 6e-3, cell = side / repeats, fraction = 0.99 * densest;
  const double diameter = cubic_array_diameter(lattice, side, repeats, fraction);
  const auto array = cubic_array(lattice, side, repeats, diameter);
  ASSERT_EQ(array.particles.size(), 27 * spheres);
  EXPECT_EQ(array.walls, Walls::periodic);
  EXPECT_NO_THROW(require_valid(array));
  EXPECT_NEAR(volume_fraction(array), fraction, 1e-14);
  EXPECT_NEAR(smallest_gap(array), nearest * cell - diameter, 1e-15);
  EXPECT_NEAR(specific_surface(array), 6.0 * fraction / diameter, 1e-9 / diameter);
  EXPECT_DOUBLE_EQ(nearest_distance(lattice), nearest);
  for (std::size_t first = 0; first < spheres; ++first) {
    std::size_t neighbours = 0;
    const double closest = GetParam().nearest * cell;
    for_each_image(array, [&](std::size_t, const Sphere& other) {
      const auto& centre = array.particles[first].centre;
      const double apart =
          std::hypot(centre[0] - other.centre[0], centre[1] - other.centre[1], centre[2] - other.centre[2]);
      if (std::abs(apart - closest) < 1e-12) ++neighbours;
    });
    EXPECT_EQ(neighbours, touching);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Lattices, CubicArray,
    ::testing::Values(LatticeFacts{Lattice::simple, 1, 1.0, 6, pi / 6.0},
                      LatticeFacts{Lattice::body_centred, 2, std::sqrt(3.0) / 2.0, 8, pi* std::sqrt(3.0) / 8.0},
                      LatticeFacts{Lattice::face_centred, 4, 1.0 / std::sqrt(2.0), 12, pi / std::sqrt(18.0)}),
    [](const auto& instance) { return name_of(instance.param.lattice); });

TEST(CubicArrays, RefuseSpheresThatTouch) {
  EXPECT_NO_THROW((void)cubic_array(Lattice::face_centred, 1.0, 1, 0.707));
  expect_error<InputError>([] { (void)cubic_array(Lattice::face_centred, 1.0, 1, 0.708); }, "fcc", "below 0.707107 m",
                           "they touch");
  expect_error<InputError>([] { (void)cubic_array_diameter(Lattice::body_centred, 1.0, 1, 0.69); }, "bcc",
                           "below 0.6802");
  expect_error<InputError>([] { (void)cubic_array(Lattice::simple, 1.0, 0, 0.5); }, "at least one cell");
  expect_error<InputError>([] { (void)cubic_array_diameter(Lattice::simple, -1.0, 1, 0.5); }, "side");
}

}  // namespace
}  // namespace breccia

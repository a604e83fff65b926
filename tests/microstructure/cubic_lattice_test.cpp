#include "breccia/microstructure/cubic_lattice.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/statistics.hpp"
#include "breccia/microstructure/validity.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using std::numbers::pi;
using test::expect_error;

/// A lattice, its balls in a cube, the distance of nearest neighbours and the densest packing.
struct Case {
  Lattice lattice;
  std::size_t balls;
  double nearest;
  double densest;
};

class CubicLattice : public testing::TestWithParam<Case> {};

TEST_P(CubicLattice, HasItsNeighboursAndItsDensestPacking) {
  const auto& [lattice, balls, nearest, densest] = GetParam();
  constexpr double cube = 2e-3;
  for (const int repeats : {1, 3}) {
    const auto box = cubic_array(repeats * cube, lattice, repeats, 0.5 * nearest * cube);
    EXPECT_NO_THROW(require_valid(box));
    EXPECT_EQ(box.particles.size(), balls * static_cast<std::size_t>(repeats * repeats * repeats));
    EXPECT_NEAR(smallest_gap(box) / cube, 0.5 * nearest, 1e-12);
    EXPECT_NEAR(volume_fraction(box), densest / 8.0, 1e-12);
  }
  const auto touching = cubic_array(cube, lattice, 1, nearest_distance(lattice) * cube);
  EXPECT_NEAR(volume_fraction(touching), densest, 1e-12);
  expect_error<InputError>([lattice = lattice, nearest = nearest] { return cubic_array(1.0, lattice, 1, 1.001 * nearest); },
                           "overlap");
}

INSTANTIATE_TEST_SUITE_P(, CubicLattice,
                         testing::Values(Case{Lattice::simple, 1, 1.0, pi / 6.0},
                                         Case{Lattice::body_centred, 2, std::sqrt(3.0) / 2.0, pi *std::sqrt(3.0) / 8.0},
                                         Case{Lattice::face_centred, 4, std::sqrt(0.5), pi / std::sqrt(18.0)}));

TEST(CubicArray, BadArguments) {
  expect_error<InputError>([] { return cubic_array(0.0, Lattice::simple, 1, 0.1); }, "expected a positive side");
  expect_error<InputError>([] { return cubic_array(1.0, Lattice::simple, 0, 0.1); }, "expected a positive side");
  expect_error<InputError>([] { return cubic_array(1.0, Lattice::simple, 1, -0.1); }, "expected a positive side");
}

}  // namespace
}  // namespace breccia

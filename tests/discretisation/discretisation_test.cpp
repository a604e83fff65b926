#include "breccia/discretisation/discretisation.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

TEST(Discretisation, StartsAsMatrix) {
  const Discretisation box({3, 2, 0.5});
  EXPECT_EQ(box.points(), 24U);
  EXPECT_EQ(box.fractions(2), (std::vector<double>{1.0, 0.0}));
}

TEST(Discretisation, PointsLieAQuarterFromTheCentre) {
  const Discretisation box({4, 4, 2.0});
  EXPECT_EQ(box.position(0, 0, 0), (Vector<2>{0.5, 0.5}));
  EXPECT_EQ(box.position(1, 2, 1), (Vector<2>{3.5, 4.5}));
  EXPECT_EQ(box.position(0, 0, 2), (Vector<2>{0.5, 1.5}));
  EXPECT_EQ(box.position(3, 3, 3), (Vector<2>{7.5, 7.5}));
}

TEST(Discretisation, SamplesTheAreaOfADisc) {
  const Microstructure one_disc = {1.0, Walls::hard, {Disc{{0.5, 0.5}, 0.6}}};
  const double exact = std::numbers::pi * 0.09;
  EXPECT_NEAR(discretise(one_disc, 50).fractions(2)[1], exact, 0.01 * exact);
  EXPECT_NEAR(discretise(one_disc, 400).fractions(2)[1], exact, 0.001 * exact);
}

TEST(Discretisation, SeesTheImagesInAPeriodicBox) {
  Microstructure corner_disc = {1.0, Walls::periodic, {Disc{{0.01, 0.02}, 0.5}}};
  const double exact = std::numbers::pi * 0.0625;
  EXPECT_NEAR(discretise(corner_disc, 200).fractions(2)[1], exact, 0.005 * exact);
  corner_disc.walls = Walls::hard;
  EXPECT_LT(discretise(corner_disc, 200).fractions(2)[1], 0.35 * exact);
}

TEST(Discretisation, DiscsAndTheirTestAgreePointByPoint) {
  const Disc disc = {{0.43, 0.61}, 0.37};
  Discretisation by_disc({37, 37, 1.0 / 37}), by_test({37, 37, 1.0 / 37});
  by_disc.paint(disc, 1);
  by_test.paint([&](const Vector<2>& point) { return disc.contains(point); }, 1);
  EXPECT_EQ(by_disc.cells(), by_test.cells());
}

TEST(Discretisation, RefusesABoxWithoutCells) {
  EXPECT_THROW(Discretisation({0, 3, 1.0}), InputError);
  EXPECT_THROW(Discretisation({3, 3, 0.0}), InputError);
}

}  // namespace
}  // namespace breccia

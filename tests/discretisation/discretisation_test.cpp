#include "breccia/discretisation/discretisation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"

namespace breccia {
namespace {

TEST(Discretisation, StartsAsMatrix) {
  const Discretisation<2> box(Grid<2>{{3, 2}, 0.5});
  EXPECT_EQ(box.points(), 24U);
  EXPECT_EQ(box.fractions(2), (std::vector<double>{1.0, 0.0}));
}

TEST(Discretisation, PointsLieAQuarterFromTheCentre) {
  const Discretisation<2> box(Grid<2>{{4, 4}, 2.0});
  EXPECT_EQ(box.position({0, 0}, 0), (Vector<2>{0.5, 0.5}));
  EXPECT_EQ(box.position({1, 2}, 1), (Vector<2>{3.5, 4.5}));
  EXPECT_EQ(box.position({0, 0}, 2), (Vector<2>{0.5, 1.5}));
  EXPECT_EQ(box.position({3, 3}, 3), (Vector<2>{7.5, 7.5}));
}

TEST(Discretisation, SamplesTheAreaOfADisc) {
  const Microstructure<2> one_disc = {1.0, Walls::hard, {Disc{{0.5, 0.5}, 0.6}}};
  const double exact = std::numbers::pi * 0.09;
  EXPECT_NEAR(discretise(one_disc, 50, 0, 1).fractions(2)[1], exact, 0.01 * exact);
  EXPECT_NEAR(discretise(one_disc, 400, 0, 1).fractions(2)[1], exact, 0.001 * exact);
}

TEST(Discretisation, SeesTheImagesInAPeriodicBox) {
  Microstructure<2> corner_disc = {1.0, Walls::periodic, {Disc{{0.01, 0.02}, 0.5}}};
  const double exact = std::numbers::pi * 0.0625;
  EXPECT_NEAR(discretise(corner_disc, 200, 0, 1).fractions(2)[1], exact, 0.005 * exact);
  corner_disc.walls = Walls::hard;
  EXPECT_LT(discretise(corner_disc, 200, 0, 1).fractions(2)[1], 0.35 * exact);
}

TEST(Discretisation, DiscsAndTheirTestAgreePointByPoint) {
  const Disc disc = {{0.43, 0.61}, 0.37};
  Discretisation<2> by_disc(Grid<2>{{37, 37}, 1.0 / 37}), by_test(Grid<2>{{37, 37}, 1.0 / 37});
  by_disc.paint(disc, 1);
  by_test.paint([&](const Vector<2>& point) { return disc.contains(point); }, 1);
  EXPECT_TRUE(std::ranges::equal(by_disc.cells(), by_test.cells()));
}

TEST(Discretisation, OfWhichACopyChangesStaysAsItIs) {
  Discretisation<2> first(Grid<2>{{3, 2}, 1.0});
  const std::vector before(first.cells().begin(), first.cells().end());
  auto copy = first;
  EXPECT_EQ(copy.cells().data(), first.cells().data());
  copy.fill({1, 1}, 1);
  EXPECT_TRUE(std::ranges::equal(first.cells(), before));
  EXPECT_FALSE(std::ranges::equal(copy.cells(), before));
  first.paint(Disc{{0.5, 0.5}, 2.0}, 2);
  EXPECT_EQ(copy.cell({0, 0}), before.front());
}

TEST(Discretisation, SamplesTheVolumeOfASphereAcrossTheSides) {
  const Microstructure<3> corner_sphere = {1.0, Walls::periodic, {{{0.01, 0.02, 0.99}, 0.6}}};
  const double exact = std::numbers::pi / 6.0 * 0.216;
  EXPECT_NEAR(discretise(corner_sphere, 30, 0, 1).fractions(2)[1], exact, 0.01 * exact);
}

TEST(Discretisation, EachParticleHasItsPhase) {
  const Microstructure<2> two_discs = {1.0, Walls::hard, {{{0.25, 0.5}, 0.4}, {{0.75, 0.5}, 0.2}}};
  const std::vector<PhaseIndex> phases = {2, 0};
  const auto box = discretise(two_discs, 200, 1, phases);
  const auto fractions = box.fractions(3);
  EXPECT_NEAR(fractions[2], std::numbers::pi * 0.04, 1e-3);
  EXPECT_NEAR(fractions[0], std::numbers::pi * 0.01, 1e-3);
  EXPECT_NEAR(fractions[1], 1.0 - std::numbers::pi * 0.05, 1e-3);
  EXPECT_EQ(box.cell({50, 100}), (CellPhases<2>{2, 2, 2, 2}));
  EXPECT_THROW((void)discretise(two_discs, 4, 1, std::vector<PhaseIndex>{2}), InputError);
}

TEST(Discretisation, RefusesABoxWithoutCells) {
  EXPECT_THROW(Discretisation<2>(Grid<2>{{0, 3}, 1.0}), InputError);
  EXPECT_THROW(Discretisation<2>(Grid<2>{{3, 3}, 0.0}), InputError);
}

TEST(RequirePhases, NamesThePhaseWithoutAMaterial) {
  Discretisation<2> box(Grid<2>{{4, 4}, 0.25});
  EXPECT_NO_THROW(require_phases("a test", box, 1));
  box.paint({{0.5, 0.5}, 0.5}, 2);
  EXPECT_EQ(test::message_of<InputError>([&] { require_phases("a test", box, 2); }),
            "a test: a point has the phase with number 2, counted from 0, but only 2 materials are given");
  EXPECT_NO_THROW(require_phases("a test", box, 3));
  box.paint({{0.5, 0.5}, 0.5}, no_phase);
  EXPECT_NO_THROW(require_phases("a test", box, 1)) << "empty cells";
}

}  // namespace
}  // namespace breccia

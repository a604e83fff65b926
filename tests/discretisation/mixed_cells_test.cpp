#include "discretisation/mixed_cells.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/discretisation/point_fields.hpp"
#include "breccia/error.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;

constexpr double pi = std::numbers::pi;
constexpr std::array<PhaseIndex, 1> filler = {1};

TEST(MixedCells, HoldTheAreaOfADisc) {
  const Microstructure<2> one_disc = {1.0, Walls::hard, {Disc{{0.51, 0.48}, 0.6}}};
  for (const int cells : {10, 50, 200}) {
    const auto mixed = discretise_mixed(one_disc, cells, 0, filler, 2);
    // Each of the cells on the circle is off by half a step at most, either way.
    const double on_circle = 8.0 * 0.3 * cells;
    EXPECT_NEAR(mixed.fractions(2)[1], pi * 0.09, 2.0 * std::sqrt(on_circle) / (2.0 * mixture_steps) / cells / cells);
    EXPECT_LE(mixed.mixtures().size(), static_cast<std::size_t>(mixture_steps) - 1);
  }
}

TEST(MixedCells, AreCellsOfOneNumber) {
  const Microstructure<2> one_disc = {1.0, Walls::hard, {Disc{{0.5, 0.5}, 1.0}}};
  const auto mixed = discretise_mixed(one_disc, 4, 0, filler, 2);
  for (const auto& cell : mixed.cells()) {
    for (const auto number : cell) EXPECT_EQ(number, cell.front());
  }
  EXPECT_EQ(mixed.mixture(mixed.cell({1, 1})[0]), nullptr);
  EXPECT_EQ(mixed.cell({1, 1})[0], 1);
  // The quarter disc around the corner cell: its area in the cell, in steps.
  const auto* corner = mixed.mixture(mixed.cell({0, 0})[0]);
  ASSERT_NE(corner, nullptr);
  EXPECT_EQ(mixed.cell({0, 0})[0], mixed.cell({3, 3})[0]);
  EXPECT_EQ((*corner)[0].phase, 0);
  EXPECT_EQ((*corner)[1].phase, 1);
  EXPECT_DOUBLE_EQ((*corner)[0].fraction + (*corner)[1].fraction, 1.0);
}

TEST(MixedCells, OfTwoDiscsInOneCellHoldBoth) {
  // A gap of a tenth of a cell in the middle of the second column.
  const Microstructure<2> two_discs = {1.0, Walls::hard, {Disc{{0.25, 0.5}, 0.49}, Disc{{0.75, 0.5}, 0.49}}};
  constexpr std::array<PhaseIndex, 2> phases = {1, 2};
  const auto mixed = discretise_mixed(two_discs, 5, 0, phases, 3);
  const auto* between = mixed.mixture(mixed.cell({2, 2})[0]);
  ASSERT_NE(between, nullptr);
  ASSERT_EQ(between->size(), 3U);
  EXPECT_EQ((*between)[1].fraction, (*between)[2].fraction);
  EXPECT_NEAR((*between)[0].fraction, 0.1, 0.05);
}

TEST(MixedCells, SeeTheImagesInAPeriodicBox) {
  const Microstructure<2> corner_disc = {1.0, Walls::periodic, {Disc{{0.01, 0.02}, 0.5}}};
  EXPECT_NEAR(discretise_mixed(corner_disc, 40, 0, filler, 2).fractions(2)[1], pi * 0.0625, 1e-4);
}

TEST(MixedCells, ThatAreHalfFilledAlongAFaceAreExact) {
  // The disc is so large that its side is a straight line within the rounding to steps.
  const Microstructure<2> half = {1.0, Walls::hard, {Disc{{-1e3 + 0.3125, 0.5}, 2e3}}};
  const auto mixed = discretise_mixed(half, 8, 0, filler, 2);
  const auto* cut = mixed.mixture(mixed.cell({2, 3})[0]);
  ASSERT_NE(cut, nullptr);
  EXPECT_EQ((*cut)[1].fraction, 0.5);
  EXPECT_EQ(mixed.cell({1, 3})[0], 1);
  EXPECT_EQ(mixed.cell({3, 3})[0], 0);
}

TEST(MixedCells, AreMaterialsToTheDynamicMethod) {
  const Microstructure<2> one_disc = {1.0, Walls::hard, {Disc{{0.5, 0.5}, 0.7}}};
  const auto mixed = discretise_mixed(one_disc, 12, 0, filler, 2);
  const std::vector<Material> phases = {{"binder", 1000.0, PronySeries(3e9), PronySeries(1e6, {{1e-3, 1e7}})},
                                        {"glass", 2500.0, PronySeries(50e9), PronySeries(30e9)}};
  const auto materials = with_mixtures(mixed, phases);
  ASSERT_EQ(materials.size(), 2 + mixed.mixtures().size());
  const auto apart = mixed.fractions(materials.size()), together = mixed.fractions(2);
  double density = 0.0, whole = 0.0;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    density += apart[m] * materials[m].density;
    whole += apart[m];
  }
  EXPECT_NEAR(whole, 1.0, 1e-12);
  EXPECT_NEAR(density, together[0] * 1000.0 + together[1] * 2500.0, 1e-9);
}

TEST(MixedCells, ShowThePhaseWithTheLargestShareInFields) {
  Discretisation<2> box(Grid<2>{{2, 1}, 1.0});
  box.fill({1, 0}, box.add_mixture({{0, 0.25}, {1, 0.75}}, 2));
  EXPECT_THAT(zero_fields(box).phase, ElementsAre(0, 0, 1, 1, 0, 0, 1, 1));
  EXPECT_THAT(zero_cell_fields(box).phase, ElementsAre(0, 1));
}

TEST(MixedCells, AreOfThePhaseOfMostPointsInFieldsOfCells) {
  Discretisation<3> box(Grid<3>{{2, 1, 1}, 1.0});
  box.paint([](const Vector<3>& place) { return place[0] > 1.0 && (place[1] > 0.5 || place[2] > 0.5); }, 1);
  const auto fields = zero_cell_fields(box);
  EXPECT_THAT(fields.phase, ElementsAre(0, 1));
  EXPECT_EQ(fields.stress.size(), 2U);
}

TEST(MixedCells, OfDiscsThatOverlapStayFilled) {
  const Microstructure<2> overlapping = {1.0, Walls::hard, {Disc{{0.5, 0.5}, 0.9}, Disc{{0.8, 0.5}, 0.3}}};
  constexpr std::array<PhaseIndex, 2> phases = {1, 1};
  const auto mixed = discretise_mixed(overlapping, 20, 0, phases, 2);
  // A cell on the left side of the smaller disc, inside the larger one.
  EXPECT_EQ(mixed.cell({13, 10})[0], 1);
  EXPECT_EQ(mixed.cell({14, 12})[0], 1);
}

TEST(MixedCells, HoldTheExactAreaOfACoating) {
  const Microstructure<2> one_disc = {1.0, Walls::hard, {Disc{{0.51, 0.48}, 0.6}}};
  const std::vector<ParticlePhases> coated = {{1, 2, 0.05}};
  for (const int cells : {10, 40, 160}) {
    const auto fractions = discretise_mixed(one_disc, cells, 0, coated, 3).fractions(3);
    const double rounding = 0.5 / mixture_steps * 6.0 / cells;
    EXPECT_NEAR(fractions[1], pi * 0.09, rounding) << cells;
    EXPECT_NEAR(fractions[2], pi * (0.1225 - 0.09), rounding) << cells;
  }
}

// A large disc whose side is straight to rounding: cells 0 and 1 are particle, 2 has 0.4 particle and 0.6 coating, 3 is
// coating, 4 has 0.2 coating.
TEST(MixedCells, InsideACoatedParticleHoldNoMatrix) {
  const Microstructure<2> half = {1.0, Walls::hard, {Disc{{-1e3 + 0.24, 0.5}, 2e3}}};
  const std::vector<ParticlePhases> coated = {{1, 2, 0.18}};
  const auto mixed = discretise_mixed(half, 10, 0, coated, 3);
  EXPECT_EQ(mixed.cell({1, 5})[0], 1);
  const auto* inside = mixed.mixture(mixed.cell({2, 5})[0]);
  ASSERT_NE(inside, nullptr);
  ASSERT_EQ(inside->size(), 2U);
  EXPECT_EQ((*inside)[0].phase, 1);
  EXPECT_NEAR((*inside)[0].fraction, 0.4, 1.0 / mixture_steps);
  EXPECT_EQ((*inside)[1].phase, 2);
  EXPECT_EQ(mixed.cell({3, 5})[0], 2);
  const auto* outside = mixed.mixture(mixed.cell({4, 5})[0]);
  ASSERT_NE(outside, nullptr);
  EXPECT_EQ((*outside)[0].phase, 0);
  EXPECT_NEAR((*outside)[1].fraction, 0.2, 1.0 / mixture_steps);
}

TEST(MixedCells, PointsOfACoatingAreBetweenItsCircles) {
  const Microstructure<3> sphere = {1.0, Walls::periodic, {{{0.1, 0.5, 0.5}, 0.4}}};
  const std::vector<ParticlePhases> coated = {{1, 2, 0.1}};
  const auto fractions = discretise<3>(sphere, 40, 0, coated).fractions(3);
  EXPECT_NEAR(fractions[1], 4.0 / 3.0 * pi * 0.008, 1e-3);
  EXPECT_NEAR(fractions[2], 4.0 / 3.0 * pi * (0.027 - 0.008), 2e-3);
}

TEST(MixedCells, AreRefusedWithoutANumberOrAPhase) {
  Discretisation<2> box(Grid<2>{{2, 1}, 1.0});
  EXPECT_THROW(box.add_mixture({{0, 0.5}, {1, 0.5}}, no_phase), InputError);
  const Microstructure<2> one_disc = {1.0, Walls::hard, {Disc{{0.5, 0.5}, 0.7}}};
  EXPECT_THROW((void)discretise_mixed(one_disc, 12, 0, std::span<const PhaseIndex>(), 2), InputError);
  constexpr std::array<PhaseIndex, 1> beyond = {2};
  EXPECT_THROW((void)discretise_mixed(one_disc, 12, 0, beyond, 2), InputError);
  EXPECT_THROW((void)discretise_mixed(one_disc, 12, 2, filler, 2), InputError);
  EXPECT_EQ(Discretisation<2>(Grid<2>{{2, 1}, 1.0}).mixture(7), nullptr);
}

}  // namespace
}  // namespace breccia

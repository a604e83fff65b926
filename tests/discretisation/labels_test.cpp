#include "discretisation/labels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "discretisation/mixed_cells.hpp"
#include "microstructure/disc_overlap.hpp"

namespace breccia {
namespace {

constexpr Disc disc = {{0.513, 0.477}, 0.61};

double distance_to_disc(const Vector<2>& place) {
  return std::hypot(place[0] - disc.centre[0], place[1] - disc.centre[1]) - 0.5 * disc.diameter;
}

PhaseAt in_disc(const Vector<2>& place) {
  const double distance = distance_to_disc(place);
  return {static_cast<PhaseIndex>(distance <= 0.0 ? 1 : 0), std::abs(distance)};
}

PhaseAt in_disc_without_clearance(const Vector<2>& place) {
  return {in_disc(place).phase};
}

TEST(Labels, GiveThePointsOfTheSameDisc) {
  const Microstructure<2> one_disc = {1.0, Walls::hard, {disc}};
  const auto painted = discretise(one_disc, 37, 0, 1);
  EXPECT_TRUE(std::ranges::equal(discretise<2>(painted.grid(), in_disc).cells(), painted.cells()));
}

TEST(Labels, GiveThePointsOfTheSameBall) {
  const Ball<3> ball = {{0.5, 0.45, 0.55}, 0.7};
  const auto painted = discretise(Microstructure<3>{1.0, Walls::hard, {ball}}, 12, 0, 1);
  const auto labelled = discretise<3>(
      painted.grid(), [&](const Vector<3>& place) { return PhaseAt{static_cast<PhaseIndex>(ball.contains(place))}; });
  EXPECT_TRUE(std::ranges::equal(labelled.cells(), painted.cells()));
}

/// Largest and root-mean-square error of the fractions of the cells that an interface crosses.
struct FractionError {
  double mean_square = 0.0;
  double largest = 0.0;
};

FractionError error_of_fractions(const Discretisation<2>& mixed) {
  FractionError error;
  int crossed = 0;
  const double h = mixed.grid().cell_side;
  mixed.grid().for_each_cell([&](const Index<2>& cell) {
    const double exact = overlap_area(disc, {cell[0] * h, cell[1] * h}, {(cell[0] + 1) * h, (cell[1] + 1) * h}) / h / h;
    if (exact < 1e-6 || exact > 1.0 - 1e-6) return;
    const auto number = mixed.cell(cell).front();
    const auto* mixture = mixed.mixture(number);
    const double fraction = mixture == nullptr ? number : mixture->back().fraction;
    error.mean_square += (fraction - exact) * (fraction - exact);
    error.largest = std::max(error.largest, std::abs(fraction - exact));
    ++crossed;
  });
  error.mean_square = std::sqrt(error.mean_square / crossed);
  return error;
}

TEST(Labels, HoldTheAreaOfEveryCellTheyCross) {
  const auto mixed = discretise_mixed({{400, 400}, 1.0 / 400}, in_disc, 2);
  const auto [mean_square, largest] = error_of_fractions(mixed);
  // Rounding to steps alone has an error of one step over the root of 12, and half a step at most.
  const double rounding = 1.0 / mixture_steps / std::sqrt(12.0);
  EXPECT_LE(std::sqrt(mean_square * mean_square - rounding * rounding), 0.002);
  EXPECT_LE(largest, 0.5 / mixture_steps + 1.0 / label_subdivisions);
}

TEST(Labels, GiveTheSameCellsWithAndWithoutClearance) {
  const Grid<2> grid = {{25, 25}, 1.0 / 25};
  const auto with = discretise_mixed(grid, in_disc, 2), without = discretise_mixed(grid, in_disc_without_clearance, 2);
  EXPECT_TRUE(std::ranges::equal(with.cells(), without.cells()));
  EXPECT_EQ(with.mixtures(), without.mixtures());
}

TEST(Labels, FindAFilmOfATwentiethOfACell) {
  constexpr double width = 0.005;
  const auto film = [](const Vector<2>& place) {
    const double distance = std::abs(0.6 * (place[0] - 0.5) - 0.8 * (place[1] - 0.43)) - 0.5 * width;
    return PhaseAt{static_cast<PhaseIndex>(distance <= 0.0 ? 1 : 0), std::abs(distance)};
  };
  const auto mixed = discretise_mixed({{10, 10}, 0.1}, film, 2);
  // The film leaves the box at its left and right sides.
  EXPECT_NEAR(mixed.fractions(2)[1], width / 0.8, 0.1 * width);
}

TEST(Labels, OfThreePhasesInOneCellHoldAll) {
  const auto bands = [](const Vector<2>& place) {
    return PhaseAt{static_cast<PhaseIndex>(place[0] < 0.25 ? 0 : place[0] < 0.375 ? 1 : 2)};
  };
  const auto mixed = discretise_mixed({{1, 1}, 1.0}, bands, 3);
  const Mixture expected = {{0, 0.25}, {1, 0.125}, {2, 0.625}};
  ASSERT_EQ(mixed.mixtures().size(), 1U);
  EXPECT_EQ(mixed.mixtures().front(), expected);
}

TEST(Labels, OfAPhaseBeyondTheNumberAreRefused) {
  EXPECT_THROW(static_cast<void>(discretise_mixed({{2, 2}, 0.5}, in_disc, 1)), InputError);
}

}  // namespace
}  // namespace breccia

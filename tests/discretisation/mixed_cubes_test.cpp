#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "discretisation/image_cells.hpp"
#include "discretisation/labels.hpp"
#include "discretisation/mixed_cells.hpp"
#include "microstructure/shapes/ellipsoid_locator.hpp"
#include "microstructure/sphere_overlap.hpp"

namespace breccia {
namespace {

constexpr std::array<PhaseIndex, 1> sphere_phase = {1};
constexpr Sphere sphere = {{0.513, 0.477, 0.492}, 0.61};

Grid<3> unit_cube(int cells) {
  return {{cells, cells, cells}, 1.0 / cells};
}

/// Fraction of phase 1 in a cell of two phases.
double fraction_in(const Discretisation<3>& mixed, const Index<3>& cell) {
  const auto number = mixed.cell(cell).front();
  const auto* mixture = mixed.mixture(number);
  return mixture == nullptr ? number : mixture->back().fraction;
}

double exact_fraction(const Grid<3>& grid, const Index<3>& cell) {
  Vector<3> lower{}, upper{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lower[axis] = cell[axis] * grid.cell_side;
    upper[axis] = lower[axis] + grid.cell_side;
  }
  return overlap_volume(sphere, lower, upper) / grid.volume() * static_cast<double>(grid.cell_count());
}

TEST(MixedCubes, HoldTheVolumeOfASphereInEveryCell) {
  const Microstructure<3> one_sphere = {1.0, Walls::hard, {sphere}};
  for (const int cells : {10, 40}) {
    const auto mixed = discretise_mixed(one_sphere, cells, 0, sphere_phase, 2);
    double largest = 0.0;
    mixed.grid().for_each_cell([&](const Index<3>& cell) {
      largest = std::max(largest, std::abs(fraction_in(mixed, cell) - exact_fraction(mixed.grid(), cell)));
    });
    EXPECT_LE(largest, 0.5 / mixture_steps + 1e-9);
    EXPECT_LE(mixed.mixtures().size(), static_cast<std::size_t>(mixture_steps) - 1);
    // The roundings of the cells on the sphere are independent.
    const double on_sphere = 1.5 * std::numbers::pi * 0.61 * 0.61 * cells * cells;
    const double rounding = std::sqrt(on_sphere / 12.0) / mixture_steps / (1.0 * cells * cells * cells);
    EXPECT_NEAR(mixed.fractions(2)[1], ball_volume<3>(0.61), 3.0 * rounding);
  }
}

TEST(MixedCubes, SeeTheImagesInAPeriodicBox) {
  const Microstructure<3> in_corner = {1.0, Walls::periodic, {{{0.01, 0.02, 0.99}, 0.6}}};
  const auto mixed = discretise_mixed(in_corner, 24, 0, sphere_phase, 2);
  EXPECT_NEAR(mixed.fractions(2)[1], ball_volume<3>(0.6), 1e-4);
  for (const Index<3>& corner : {Index<3>{0, 0, 0}, {23, 0, 0}, {23, 23, 0}, {23, 23, 23}}) {
    EXPECT_EQ(mixed.cell(corner)[0], 1);
  }
}

TEST(MixedCubes, OfTwoFillersInOneCellHoldBoth) {
  const Microstructure<3> pair = {1.0, Walls::hard, {{{0.25, 0.5, 0.5}, 0.49}, {{0.75, 0.5, 0.5}, 0.49}}};
  constexpr std::array<PhaseIndex, 2> phases = {1, 2};
  const auto mixed = discretise_mixed(pair, 5, 0, phases, 3);
  const auto* between = mixed.mixture(mixed.cell({2, 2, 2})[0]);
  ASSERT_NE(between, nullptr);
  ASSERT_EQ(between->size(), 3U);
  EXPECT_EQ((*between)[1].fraction, (*between)[2].fraction);
}

TEST(MixedCubes, HoldTheVolumeOfACoating) {
  const Microstructure<3> one_sphere = {1.0, Walls::hard, {sphere}};
  const std::vector<ParticlePhases> coated = {{1, 2, 0.05}};
  const auto fractions = discretise_mixed(one_sphere, 40, 0, coated, 3).fractions(3);
  EXPECT_NEAR(fractions[1], ball_volume<3>(0.61), 1e-4);
  EXPECT_NEAR(fractions[2], ball_volume<3>(0.71) - ball_volume<3>(0.61), 2e-4);
}

// The sphere is so large that its surface is a plane within the rounding to steps: one cell is particle and coating
// alone.
TEST(MixedCubes, InsideACoatedParticleHoldNoMatrix) {
  const Microstructure<3> half = {1.0, Walls::hard, {{{-1e3 + 0.24, 0.5, 0.5}, 2e3}}};
  const std::vector<ParticlePhases> coated = {{1, 2, 0.18}};
  const auto mixed = discretise_mixed(half, 10, 0, coated, 3);
  EXPECT_EQ(mixed.cell({1, 5, 4})[0], 1);
  const auto* inside = mixed.mixture(mixed.cell({2, 5, 4})[0]);
  ASSERT_NE(inside, nullptr);
  ASSERT_EQ(inside->size(), 2U);
  EXPECT_EQ((*inside)[0].phase, 1);
  EXPECT_NEAR((*inside)[0].fraction, 0.4, 1.0 / mixture_steps);
  EXPECT_EQ(mixed.cell({3, 5, 4})[0], 2);
}

TEST(MixedCubes, OfALabellingAreNearTheExactOnes) {
  const auto in_sphere = [](const Vector<3>& place) {
    double square = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      square += (place[axis] - sphere.centre[axis]) * (place[axis] - sphere.centre[axis]);
    }
    const double distance = std::sqrt(square) - 0.5 * sphere.diameter;
    return PhaseAt{static_cast<PhaseIndex>(distance <= 0.0 ? 1 : 0), std::abs(distance)};
  };
  const auto mixed = discretise_mixed(unit_cube(40), in_sphere, 2);
  double sum = 0.0, largest = 0.0;
  int crossed = 0;
  mixed.grid().for_each_cell([&](const Index<3>& cell) {
    const double exact = exact_fraction(mixed.grid(), cell);
    if (exact < 1e-6 || exact > 1.0 - 1e-6) return;
    const double error = fraction_in(mixed, cell) - exact;
    sum += error * error;
    largest = std::max(largest, std::abs(error));
    ++crossed;
  });
  // Rounding to steps alone has an error of one step over the root of 12, and half a step at most.
  const double rounding = 1.0 / mixture_steps / std::sqrt(12.0);
  EXPECT_LE(std::sqrt(std::max(0.0, sum / crossed - rounding * rounding)), 0.004);
  EXPECT_LE(largest, 0.5 / mixture_steps + 1.0 / cube_label_subdivisions);
  EXPECT_THROW((void)discretise_mixed(unit_cube(2), in_sphere, 1), InputError);
}

TEST(MixedCubes, OfEllipsoidsHoldTheirVolumes) {
  EllipsoidBox box = {1.0, Walls::periodic};
  box.particles = {{{0.1, 0.4, 0.3}, {0.8, 0.4, 0.3}, turned({1.0, 0.2, 0.5, -0.3})},
                   {{0.6, 0.8, 0.8}, {0.5, 0.3, 0.3}, turned({0.3, 1.0, -0.4, 0.7})}};
  ASSERT_NO_THROW(require_valid(box));
  const EllipsoidLocator locator(box);
  const auto in_ellipsoid = [&](const Vector<3>& place) {
    const auto distance = locator.at(place).distance;
    return PhaseAt{static_cast<PhaseIndex>(distance <= 0.0 ? 1 : 0), std::abs(distance)};
  };
  EXPECT_NEAR(discretise_mixed(unit_cube(24), in_ellipsoid, 2).fractions(2)[1], volume_fraction(box), 2e-4);
}

/// Voxels of two labels in a pattern without a symmetry.
LabelImage<3> voxels(int count) {
  LabelImage<3> image = {{count, count, count}, 1.0 / count, Walls::hard, {}};
  for_each_index(Index<3>{}, image.pixels, [&](const Index<3>& voxel) {
    image.labels.push_back(static_cast<Label>((3 * voxel[0] + 5 * voxel[1] + 7 * voxel[2]) % 4 == 0 ? 1 : 0));
  });
  return image;
}

TEST(MixedCubes, OfAnImageHoldTheVolumesOfItsVoxels) {
  const std::vector<PhaseIndex> same = {0, 1};
  const auto image = voxels(6);
  // Whole voxels, and cells of one and a half along each axis.
  const auto whole = discretise_mixed(unit_cube(6), image, same, 2);
  EXPECT_TRUE(whole.mixtures().empty());
  whole.grid().for_each_cell(
      [&](const Index<3>& cell) { EXPECT_EQ(whole.cell(cell)[0], image.labels[whole.grid().cell_index(cell)]); });
  const auto mixed = discretise_mixed(unit_cube(4), image, same, 2);
  double share = 0.0;  // share of the first cell, by eighths of voxels
  for_each_index(Index<3>{}, Index<3>{3, 3, 3}, [&](const Index<3>& half) {
    const std::size_t voxel = static_cast<std::size_t>(half[0] / 2) + 6 * static_cast<std::size_t>(half[1] / 2) +
                              36 * static_cast<std::size_t>(half[2] / 2);
    share += image.labels[voxel] / 27.0;
  });
  EXPECT_NEAR(fraction_in(mixed, {0, 0, 0}), share, 0.5 / mixture_steps);
  const auto points = discretise(unit_cube(3), image, same);
  points.grid().for_each_cell([&](const Index<3>& cell) {
    for (int point = 0; point < 8; ++point) {
      EXPECT_EQ(points.cell(cell)[static_cast<std::size_t>(point)], image.label_at(points.position(cell, point)));
    }
  });
}

}  // namespace
}  // namespace breccia

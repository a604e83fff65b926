#include "microstructure/tessellation/tessellation_statistics.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>

#include "breccia/error.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;

/// Bands of the widths 3 and 1 in a box of side 4.
Tessellation<2> bands(Walls walls) {
  return Tessellation<2>({4.0, walls, {{{1.5, 2.0}, 0.0}, {{3.5, 2.0}, -2.0}}});
}

TEST(TessellationStatistics, OfBands) {
  const auto tessellation = bands(Walls::periodic);
  const auto grains = grain_geometries(tessellation, 0.5);
  EXPECT_NEAR(grains[0].cell_volume, 12.0, 1e-13);
  EXPECT_NEAR(grains[1].cell_volume, 4.0, 1e-13);
  EXPECT_NEAR(grains[0].grain_volume, 2.5 * 3.5, 1e-13);
  EXPECT_NEAR(grains[0].grain_surface, 12.0, 1e-13);
  EXPECT_NEAR(grains[0].diameter, 2.0 * std::sqrt(2.5 * 3.5 / std::numbers::pi), 1e-13);
  EXPECT_NEAR(grains[0].aspect_ratio, 4.0 / 3.0, 1e-13);
  EXPECT_NEAR(grains[1].aspect_ratio, 4.0, 1e-12);
  EXPECT_EQ(grains[0].faces, 4);
  EXPECT_EQ(grains[0].neighbours, 1) << "the other band, twice, and itself";

  const auto all = statistics(tessellation, 0.5);
  EXPECT_EQ(all.grains, 2);
  EXPECT_EQ(all.vanished, 0);
  EXPECT_NEAR(all.fraction, (2.5 * 3.5 + 0.5 * 3.5) / 16.0, 1e-14);
  EXPECT_NEAR(all.film_surface, 3.0 * 4.0 / 16.0, 1e-14);  // two upright films and one along the box
  EXPECT_NEAR(all.cell_volume.mean, 8.0, 1e-13);
  EXPECT_NEAR(all.cell_volume.deviation, 4.0, 1e-13);
  EXPECT_NEAR(all.cell_volume.smallest, 4.0, 1e-13);
  EXPECT_NEAR(all.cell_volume.largest, 12.0, 1e-13);
  EXPECT_EQ(all.mean_faces, 4.0);
}

TEST(TessellationStatistics, CountsGrainsThatVanish) {
  const auto all = statistics(bands(Walls::periodic), 1.1);
  EXPECT_EQ(all.vanished, 1);
  EXPECT_EQ(all.diameter.smallest, 0.0);
  EXPECT_NEAR(all.fraction, 1.9 * 2.9 / 16.0, 1e-14);
}

TEST(TessellationStatistics, WallsAreNoFaces) {
  const auto all = statistics(bands(Walls::hard), 0.0);
  EXPECT_EQ(all.mean_faces, 1.0);
  EXPECT_NEAR(all.film_surface, (4.0 + 0.5 * 16.0) / 16.0, 1e-14);  // half a film along the walls
}

TEST(TessellationStatistics, OfACube) {
  const Tessellation<3> cube({2.0, Walls::periodic, {{{0.5, 0.5, 0.5}, 0.0}}});
  const auto [grain] = std::array{grain_geometries(cube, 0.2)[0]};
  EXPECT_NEAR(grain.grain_volume, 1.8 * 1.8 * 1.8, 1e-14);
  EXPECT_NEAR(grain.diameter, 1.8 * std::cbrt(6.0 / std::numbers::pi), 1e-14);
  EXPECT_EQ(grain.faces, 6);
  EXPECT_EQ(grain.neighbours, 0) << "images of itself";
  EXPECT_NEAR(statistics(cube, 0.2).film_surface, 3.0 * 4.0 / 8.0, 1e-14);
}

TEST(TessellationStatistics, LargestError) {
  const auto tessellation = bands(Walls::periodic);
  EXPECT_NEAR(largest_volume_error<2>(tessellation, std::vector{3.0, 1.0}), 0.0, 1e-13);
  EXPECT_NEAR(largest_volume_error<2>(tessellation, std::vector{1.0, 1.0}), 0.5, 1e-13);
  expect_error<InputError>([&] { return largest_volume_error<2>(tessellation, std::vector{1.0}); }, "2 cells");
}

}  // namespace
}  // namespace breccia

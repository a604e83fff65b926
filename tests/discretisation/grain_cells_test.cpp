#include "discretisation/grain_cells.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "discretisation/mixed_cells.hpp"
#include "microstructure/tessellation/grain_locator.hpp"

namespace breccia {
namespace {

/// Fraction of phase 1 in a cell of two phases.
template <int dim>
double fraction_in(const Discretisation<dim>& mixed, const Index<dim>& cell) {
  const auto number = mixed.cell(cell).front();
  const auto* mixture = mixed.mixture(number);
  return mixture == nullptr ? number : mixture->back().fraction;
}

/// Grains of equal weights at positions with irrational steps between them.
template <int dim>
Tessellation<dim> grains_in_unit_box(int count, Walls walls, WallFilm wall_film = WallFilm::half) {
  constexpr std::array steps = {0.8191725134, 0.6710436067, 0.5497004779};
  LaguerreSites<dim> sites = {1.0, walls, {}, wall_film};
  for (int k = 0; k < count; ++k) {
    Site<dim> site;
    for (std::size_t axis = 0; axis < site.position.size(); ++axis) {
      site.position[axis] = std::fmod((k + 0.5) * steps[axis], 1.0);
    }
    site.weight = 0.001 * (k % 5);
    sites.sites.push_back(site);
  }
  return Tessellation<dim>(sites);
}

// The roundings of the cells are independent, so that their mean is much smaller than a step.
TEST(GrainCells, HoldTheVolumeOfTheGrains) {
  for (const auto walls : {Walls::periodic, Walls::hard}) {
    const auto grains = grains_in_unit_box<3>(20, walls);
    const double film = film_thickness(grains, 0.8);
    EXPECT_NEAR(discretise_mixed(grains, film, 24, 0, 1, 2).fractions(2)[1], 0.8, 1e-3);
    const auto polygons = grains_in_unit_box<2>(20, walls);
    EXPECT_NEAR(discretise_mixed(polygons, film_thickness(polygons, 0.9), 60, 0, 1, 2).fractions(2)[1], 0.9, 1e-3);
  }
  const auto cut = grains_in_unit_box<3>(20, Walls::hard, WallFilm::none);
  EXPECT_NEAR(discretise_mixed(cut, film_thickness(cut, 0.85), 24, 0, 1, 2).fractions(2)[1], 0.85, 1e-3);
}

// Two grains in a periodic box, with films of 0.1 between each other and their own images: the first fills the box from
// 0.05 to 0.45 along x and from 0.05 to 0.95 along y and z.
TEST(GrainCells, OfBlocksAreExact) {
  const Tessellation<3> blocks({1.0, Walls::periodic, {{{0.25, 0.5, 0.5}}, {{0.75, 0.5, 0.5}}}});
  const auto mixed = discretise_mixed(blocks, 0.1, 8, 0, 1, 2);
  constexpr double rounding = 0.5 / mixture_steps + 1e-9;
  EXPECT_EQ(fraction_in(mixed, {1, 3, 4}), 1.0);
  EXPECT_NEAR(fraction_in(mixed, {0, 3, 4}), 0.6, rounding);
  EXPECT_NEAR(fraction_in(mixed, {3, 6, 4}), 0.6, rounding);
  EXPECT_NEAR(fraction_in(mixed, {5, 0, 7}), 0.36, rounding);
  EXPECT_NEAR(fraction_in(mixed, {4, 7, 0}), 0.216, rounding);
  EXPECT_EQ(mixed.mixtures().size(), 3U);
}

/// Counts the points of a fine lattice in each cell that are in a grain.
template <int dim>
void expect_counted_shares(const Tessellation<dim>& grains, double film, int cells, int places, double tolerance) {
  const auto mixed = discretise_mixed(grains, film, cells, 0, 1, 2);
  const GrainLocator<dim> locator(grains, film);
  Index<dim> all{};
  all.fill(places);
  mixed.grid().for_each_cell([&](const Index<dim>& cell) {
    int inside = 0, count = 0;
    for_each_index(Index<dim>{}, all, [&](const Index<dim>& place) {
      Vector<dim> position{};
      for (std::size_t axis = 0; axis < position.size(); ++axis) {
        position[axis] = (cell[axis] + (place[axis] + 0.5) / places) * mixed.grid().cell_side;
      }
      inside += locator.at(position).is_in_grain() ? 1 : 0;
      ++count;
    });
    EXPECT_NEAR(fraction_in(mixed, cell), static_cast<double>(inside) / count, tolerance);
  });
}

TEST(GrainCells, AgreeWithPlacesThatAreCounted) {
  expect_counted_shares(grains_in_unit_box<3>(6, Walls::periodic), 0.07, 6, 16, 0.5 / mixture_steps + 0.04);
  expect_counted_shares(grains_in_unit_box<3>(5, Walls::hard), 0.05, 5, 16, 0.5 / mixture_steps + 0.04);
  expect_counted_shares(grains_in_unit_box<2>(6, Walls::periodic), 0.07, 9, 60, 0.5 / mixture_steps + 0.02);
}

TEST(GrainCells, WithoutAFilmAreGrainsAlone) {
  const auto mixed = discretise_mixed(grains_in_unit_box<3>(10, Walls::periodic), 0.0, 10, 0, 1, 2);
  EXPECT_TRUE(mixed.mixtures().empty());
  EXPECT_EQ(mixed.fractions(2)[1], 1.0);
}

TEST(GrainCells, AreRefusedWithoutAPhaseOrAFilm) {
  const auto grains = grains_in_unit_box<3>(3, Walls::periodic);
  EXPECT_THROW((void)discretise_mixed(grains, 0.1, 4, 0, 2, 2), InputError);
  EXPECT_THROW((void)discretise_mixed(grains, -0.1, 4, 0, 1, 2), InputError);
}

}  // namespace
}  // namespace breccia

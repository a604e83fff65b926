#include "breccia/microstructure/tessellation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <gmock/gmock.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/random_sites.hpp"

#include "brute_force_tessellation.hpp"
#include "expect_error.hpp"
#include "microstructure/tessellation/grain_locator.hpp"
#include "sum.hpp"
#include "voronoi_sites_25.hpp"

namespace breccia {
namespace {

using test::diameters_of_ratio;
using test::expect_error;
using test::sum;
using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::SizeIs;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Sites of weight zero.
template <int dim>
LaguerreSites<dim> unweighted(double side, Walls walls, const std::vector<Vector<dim>>& positions) {
  LaguerreSites<dim> sites{side, walls, {}};
  for (const auto& position : positions) sites.sites.push_back({position, 0.0});
  return sites;
}

template <int dim>
std::vector<Vector<dim>> lattice(int repeats, double pitch, const std::vector<Vector<dim>>& basis) {
  std::vector<Vector<dim>> positions;
  Index<dim> end;
  end.fill(repeats);
  for_each_index(Index<dim>{}, end, [&](const Index<dim>& cell) {
    for (auto position : basis) {
      for (std::size_t axis = 0; axis < dim; ++axis) position[axis] = (position[axis] + cell[axis]) * pitch;
      positions.push_back(position);
    }
  });
  return positions;
}

/// Two sites side by side in a box of side 4: the plane between them is off its middle by (w1 - w2) / 4.
LaguerreSites<2> two_bands(Walls walls) {
  return {4.0, walls, {{{1.0, 2.0}, 0.8}, {{3.0, 2.0}, 0.0}}};
}

TEST(Tessellation, SquareLattice) {
  const Tessellation<2> tessellation(unweighted<2>(4.0, Walls::periodic, lattice<2>(4, 1.0, {{0.5, 0.5}})));
  EXPECT_THAT(cell_volumes(tessellation), Each(DoubleNear(1.0, 1e-15)));
  EXPECT_THAT(tessellation.cell(5).half_spaces(), SizeIs(4));
  EXPECT_NEAR(volume(tessellation.grain(5, 0.1)), 0.81, 1e-15);
  EXPECT_NEAR(grain_fraction(tessellation, 0.1), 0.81, 1e-14);
}

TEST(Tessellation, HexagonsAndTheirFilms) {
  // Rows at the distance a with sites b apart, every other one shifted by b / 2: nearly regular hexagons.
  const double b = 1.0 / 7.0;
  const double a = 1.0 / 8.0;
  std::vector<Vector<2>> positions;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 7; ++column) positions.push_back({(column + 0.5 * (row % 2)) * b, row * a});
  }
  const Tessellation<2> tessellation(unweighted<2>(1.0, Walls::periodic, positions));
  EXPECT_THAT(cell_volumes(tessellation), Each(DoubleNear(a * b, 1e-16)));
  // Two upright sides of length s at b/2 and four at half the distance d of the neighbours in the next row.
  const double d = std::hypot(a, 0.5 * b);
  const double upright = a - b * b / (4.0 * a);
  const double slanted = (a * b - 0.5 * b * upright) / d;
  const auto faces = face_measures(tessellation.cell(10));
  EXPECT_THAT(faces, SizeIs(6));
  EXPECT_NEAR(sum(faces), 2.0 * upright + 4.0 * slanted, 1e-14);
  // All sides recede by t/2: the perimeter shrinks by the parts that the six corners lose, tan(half the turn) each.
  const double turn = std::acos(0.5 * b / d);  // from an upright to a slanted side
  const double corners = 4.0 * std::tan(0.5 * turn) + 2.0 * std::tan(0.5 * (std::numbers::pi - 2.0 * turn));
  const double film = 0.01;
  EXPECT_NEAR(volume(tessellation.grain(10, film)), a * b - 0.5 * film * sum(faces) + 0.25 * film * film * corners,
              1e-15);
}

TEST(Tessellation, BandsOfWeightedSites) {
  const Tessellation<2> periodic(two_bands(Walls::periodic));
  EXPECT_THAT(cell_volumes(periodic), ::testing::ElementsAre(DoubleNear(9.6, 1e-14), DoubleNear(6.4, 1e-14)));
  EXPECT_NEAR(volume(periodic.grain(0, 0.5)), 1.9 * 3.5, 1e-14);
  EXPECT_NEAR(volume(periodic.grain(1, 0.5)), 1.1 * 3.5, 1e-14);

  const Tessellation<2> walls(two_bands(Walls::hard));
  EXPECT_THAT(cell_volumes(walls), ::testing::ElementsAre(DoubleNear(8.8, 1e-14), DoubleNear(7.2, 1e-14)));
  EXPECT_NEAR(volume(walls.grain(0, 0.5)), 1.7 * 3.5, 1e-14);
}

// The film between the bands has the mean of their shares; the films to their own images, and along walls, have the
// share of the band.
TEST(Tessellation, SharesOfTheFilms) {
  auto sites = two_bands(Walls::periodic);
  sites.film_shares = {0.5, 1.5};
  const Tessellation<2> periodic(sites);
  EXPECT_NEAR(volume(periodic.grain(0, 0.5)), 1.9 * 3.75, 1e-14);
  EXPECT_NEAR(volume(periodic.grain(1, 0.5)), 1.1 * 3.25, 1e-14);
  EXPECT_NEAR(film_thickness(periodic, grain_fraction(periodic, 0.5)), 0.5, 1e-12);

  // Shares may have any scale: the thicknesses of the films scale with it.
  auto small = sites;
  small.film_shares = {0.5e-5, 1.5e-5};
  EXPECT_NEAR(film_thickness(Tessellation<2>(small), grain_fraction(periodic, 0.5)), 0.5e5, 1e-7);

  sites.walls = Walls::hard;
  const Tessellation<2> walls(sites);
  EXPECT_NEAR(volume(walls.grain(0, 0.5)), (2.2 - 0.125 - 0.25) * 3.75, 1e-14);
  sites.wall_film = WallFilm::none;
  EXPECT_NEAR(volume(Tessellation<2>(sites).grain(1, 0.5)), (1.8 - 0.25) * 4.0, 1e-14);

  // Two slabs of 2.4 and 1.6 in a periodic cube of 4.
  LaguerreSites<3> slabs = {4.0, Walls::periodic, {{{1.0, 2.0, 2.0}, 0.8}, {{3.0, 2.0, 2.0}, 0.0}}};
  slabs.film_shares = {0.5, 1.5};
  const Tessellation<3> in_space(slabs);
  EXPECT_THAT(cell_volumes(in_space), ::testing::ElementsAre(DoubleNear(38.4, 1e-13), DoubleNear(25.6, 1e-13)));
  EXPECT_NEAR(volume(in_space.grain(0, 0.5)), 1.9 * 3.75 * 3.75, 1e-13);
  EXPECT_NEAR(volume(in_space.grain(1, 0.5)), 1.1 * 3.25 * 3.25, 1e-13);
  EXPECT_NEAR(film_thickness(in_space, grain_fraction(in_space, 0.5)), 0.5, 1e-12);

  sites.film_shares = {0.5, 0.0};
  expect_error<InputError>([&] { Tessellation<2> refused(sites); }, "site 2: the share 0 of the films is not positive");
  sites.film_shares = {1.0};
  expect_error<InputError>([&] { Tessellation<2> refused(sites); },
                           "a share of the films for each of 2 sites, or none, got 1");
}

// The neighbour beyond a face lies along its normal, displaced by whole sides.
TEST(Tessellation, KnowsWhichImageIsBeyondAFace) {
  auto sites = test::voronoi_sites_25();
  for (const auto walls : {Walls::periodic, Walls::hard}) {
    sites.walls = walls;
    const Tessellation<2> tessellation(sites);
    for (std::size_t site = 0; site < tessellation.size(); ++site) {
      for (const auto& face : tessellation.cell(site).half_spaces()) {
        const auto image = Tessellation<2>::image(face);
        if (walls == Walls::hard) {
          EXPECT_EQ(image, (Index<2>{}));
        }
        const auto neighbour = Tessellation<2>::neighbour(face);
        if (!neighbour) continue;
        Vector<2> apart{};
        for (std::size_t axis = 0; axis < 2; ++axis) {
          apart[axis] = sites.sites[*neighbour].position[axis] + image[axis] - sites.sites[site].position[axis];
        }
        EXPECT_NEAR(apart[0] * face.normal[0] + apart[1] * face.normal[1], 2.0 * face.offset, 1e-12);
        EXPECT_NEAR(apart[0] * face.normal[1] - apart[1] * face.normal[0], 0.0, 1e-12);
      }
    }
  }
}

TEST(Tessellation, KnowsWhatLiesBehindAFace) {
  const auto neighbours = [](const Tessellation<2>& tessellation) {
    std::vector<std::optional<std::size_t>> found;
    for (const auto& face : tessellation.cell(0).half_spaces()) found.push_back(Tessellation<2>::neighbour(face));
    return found;
  };
  EXPECT_THAT(neighbours(Tessellation<2>(two_bands(Walls::periodic))), ::testing::UnorderedElementsAre(0, 0, 1, 1));
  EXPECT_THAT(neighbours(Tessellation<2>(two_bands(Walls::hard))),
              ::testing::UnorderedElementsAre(std::nullopt, std::nullopt, std::nullopt, 1));
}

TEST(Tessellation, OneSiteFillsTheBox) {
  const Tessellation<3> tessellation(unweighted<3>(2.0, Walls::periodic, {{0.3, 1.9, 0.0}}));
  EXPECT_DOUBLE_EQ(grain_fraction(tessellation, 0.2), 0.9 * 0.9 * 0.9);
  EXPECT_NEAR(film_thickness(tessellation, 0.729), 0.2, 1e-14);
}

TEST(Tessellation, CubicLattices) {
  const Tessellation<3> cubes(unweighted<3>(1.0, Walls::periodic, lattice<3>(3, 1.0 / 3.0, {{0.1, 0.2, 0.3}})));
  EXPECT_THAT(cell_volumes(cubes), Each(DoubleNear(1.0 / 27.0, 1e-15)));
  EXPECT_NEAR(grain_fraction(cubes, 1.0 / 30.0), 0.729, 1e-14);

  // Truncated octahedra, and rhombic dodecahedra, which have four faces in some corners and all at one distance, so
  // that the grain is similar to the cell.
  const Tessellation<3> bcc(unweighted<3>(1.0, Walls::periodic, lattice<3>(2, 0.5, {{0, 0, 0}, {0.5, 0.5, 0.5}})));
  EXPECT_THAT(bcc.cell(3).half_spaces(), SizeIs(14));
  EXPECT_THAT(cell_volumes(bcc), Each(DoubleNear(1.0 / 16.0, 1e-15)));
  const Tessellation<3> fcc(unweighted<3>(
      1.0, Walls::periodic, lattice<3>(2, 0.5, {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}})));
  EXPECT_THAT(fcc.cell(3).half_spaces(), SizeIs(12));
  EXPECT_THAT(cell_volumes(fcc), Each(DoubleNear(1.0 / 32.0, 1e-15)));
  const double half_distance = 0.125 * std::sqrt(2.0);  // half the distance of the neighbours
  EXPECT_NEAR(grain_fraction(fcc, 0.2 * half_distance), 0.729, 1e-14);
  EXPECT_NEAR(film_thickness(fcc, 0.729), 0.2 * half_distance, 1e-14);
}

TEST(Tessellation, FillsTheBox) {
  for (const auto walls : {Walls::periodic, Walls::hard}) {
    const Tessellation<2> plane(random_sites<2>({3.0, walls, diameters_of_ratio(150, 50.0), 4, 0, 1e-6}));
    EXPECT_NEAR(sum(cell_volumes(plane)), 9.0, 1e-11);
    const Tessellation<3> space(random_sites<3>({3.0, walls, diameters_of_ratio(100, 10.0), 4, 0, 1e-6}));
    EXPECT_NEAR(sum(cell_volumes(space)), 27.0, 1e-11);
  }
}

// The expected fraction of 91.11 % was computed by an independent prototype.
TEST(Tessellation, TwentyFiveVoronoiGrains) {
  const Tessellation<2> tessellation(test::voronoi_sites_25());
  EXPECT_NEAR(sum(cell_volumes(tessellation)), 1.0, 1e-14);
  EXPECT_NEAR(grain_fraction(tessellation, 2.4 / 256.0), 0.9111, 5e-5);
  EXPECT_NEAR(film_thickness(tessellation, grain_fraction(tessellation, 2.4 / 256.0)), 2.4 / 256.0, 1e-14);
}

TEST(Tessellation, TranslationChangesNothing) {
  auto sites = random_sites<2>({2.0, Walls::periodic, diameters_of_ratio(60, 20.0), 11, 1, 1e-9});
  const Tessellation<2> before(sites);
  for (auto& site : sites.sites) {
    site.position = {std::fmod(site.position[0] + 1.2345, 2.0), std::fmod(site.position[1] + 0.777, 2.0)};
  }
  const Tessellation<2> after(sites);
  for (std::size_t site = 0; site < before.size(); ++site) {
    EXPECT_NEAR(volume(after.cell(site)), volume(before.cell(site)), 1e-13);
    EXPECT_THAT(after.cell(site).half_spaces(), SizeIs(before.cell(site).half_spaces().size()));
  }
  EXPECT_NEAR(film_thickness(after, 0.9), film_thickness(before, 0.9), 1e-13);
}

TEST(Tessellation, ANumberAddedToAllWeightsChangesNothing) {
  auto sites = random_sites<3>({2.0, Walls::periodic, diameters_of_ratio(40, 5.0), 2, 1, 1e-6});
  const auto before = cell_volumes(Tessellation<3>(sites));
  for (auto& site : sites.sites) site.weight -= 7.0;
  EXPECT_THAT(cell_volumes(Tessellation<3>(sites)), ::testing::Pointwise(DoubleNear(1e-12), before));
}

TEST(Tessellation, FilmOfAFraction) {
  const Tessellation<2> plane(random_sites<2>({1e-3, Walls::periodic, diameters_of_ratio(300, 50.0), 5, 2, 1e-6}));
  for (const double fraction : {0.05, 0.5, 0.8, 0.937, 0.97, 0.999, 1.0 - 1e-9, 1.0 - 1e-15, 1.0}) {
    EXPECT_NEAR(grain_fraction(plane, film_thickness(plane, fraction)), fraction, 1e-13) << fraction;
  }
  EXPECT_NEAR(film_thickness(plane, 1.0), 0.0, 1e-17);
  EXPECT_NEAR(grain_fraction(plane, 0.0), 1.0, 1e-12);
  EXPECT_EQ(grain_fraction(plane, 1e-3), 0.0);
  const Tessellation<3> space(random_sites<3>({1e-3, Walls::hard, diameters_of_ratio(60, 5.0), 5, 1, 1e-6}));
  EXPECT_NEAR(grain_fraction(space, film_thickness(space, 0.9)), 0.9, 1e-13);
}

TEST(Tessellation, WallsWithoutAFilmCutGrainsAndFilms) {
  auto sites = two_bands(Walls::hard);
  sites.wall_film = WallFilm::none;
  const Tessellation<2> bands(sites);
  EXPECT_NEAR(grain_fraction(bands, 0.4), 1.0 - 0.4 / 4.0, 1e-14) << "one film across the box, none along its sides";
  EXPECT_NEAR(film_thickness(bands, 0.9), 0.4, 1e-12);
  const GrainLocator<2> locator(bands, 0.4);
  EXPECT_TRUE(locator.at({0.01, 0.01}).is_in_grain());
  EXPECT_FALSE(locator.at({2.2, 0.01}).is_in_grain());
}

TEST(Tessellation, BadArguments) {
  const Tessellation<2> tessellation(test::voronoi_sites_25());
  for (const double film : {-1e-9, infinite, std::nan("")}) {
    expect_error<InputError>([&] { return grain_fraction(tessellation, film); }, "thickness of the film");
  }
  for (const double fraction : {0.0, -0.5, 1.1, std::nan("")}) {
    expect_error<InputError>([&] { return film_thickness(tessellation, fraction); }, "above 0 and at most 1");
  }
}

TEST(Tessellation, ListsEverySiteThatCannotBe) {
  const LaguerreSites<2> sites{
      1.0, Walls::periodic, {{{0.5, 0.5}, 0.0}, {{1.5, 0.5}, 0.0}, {{0.2, std::nan("")}, 0.0}, {{0.1, 0.9}, infinite}}};
  expect_error<InputError>([&] { return Tessellation<2>(sites); }, "site 2: the position (1.5 m, 0.5 m) is outside",
                           "site 3", "site 4: the weight inf m^2 is not finite");
  const auto found = mistakes(sites);
  ASSERT_THAT(found, SizeIs(3));
  EXPECT_EQ(found[0].site, 1);
}

TEST(Tessellation, ListsEverySiteWithoutACell) {
  const LaguerreSites<2> sites{
      1.0, Walls::hard, {{{0.5, 0.5}, 0.0}, {{0.5, 0.6}, 0.3}, {{0.1, 0.1}, 0.0}, {{0.1, 0.1}, 0.0}}};
  expect_error<InputError>([&] { return Tessellation<2>(sites); }, "site 1: no point", "site 4: no point");
  EXPECT_THAT(mistakes(sites), SizeIs(2));
}

TEST(Tessellation, SitesOnOppositeSidesOfAPeriodicBoxAreAtTheSamePlace) {
  const LaguerreSites<2> sites{1.0, Walls::periodic, {{{0.0, 0.5}, 0.0}, {{1.0, 0.5}, 0.0}}};
  expect_error<InputError>([&] { return Tessellation<2>(sites); }, "site 2: no point");
}

TEST(Tessellation, NoBoxNoSites) {
  expect_error<InputError>([] { return Tessellation<2>({0.0, Walls::hard, {{{0.0, 0.0}, 0.0}}}); }, "side of the box");
  expect_error<InputError>(
      [] {
        return Tessellation<2>({infinite, Walls::hard, {{{0.0, 0.0}, 0.0}}});
      },
      "side of the box");
  expect_error<InputError>([] { return Tessellation<3>({1.0, Walls::hard, {}}); }, "from 1 to");
}

}  // namespace
}  // namespace breccia

#include "microstructure/tessellation/grain_locator.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/random_sites.hpp"

#include "brute_force_tessellation.hpp"
#include "expect_error.hpp"

namespace breccia {
namespace {

using test::DefinedTessellation;
using test::diameters_of_ratio;
using test::expect_error;
using test::random_points;

/// Compares the locator with the definition at random points, with images up to `boxes` boxes away. Returns the share
/// of the points that are in the film.
template <int dim>
double compare_with_definition(const LaguerreSites<dim>& sites, double film, std::size_t points, int boxes) {
  const Tessellation<dim> tessellation(sites);
  const GrainLocator<dim> locator(tessellation, film);
  const DefinedTessellation<dim> definition(sites, film, boxes);
  const double roundoff = 1e-13 * sites.side;
  std::size_t in_film = 0;
  for (const auto& point : random_points<dim>(points, sites.side, 17)) {
    const auto expected = definition.at(point);
    const auto found = locator.at(point);
    EXPECT_EQ(found.site, expected.site);
    EXPECT_NEAR(found.depth, expected.depth, roundoff);
    if (std::abs(expected.depth) > roundoff) {
      EXPECT_EQ(found.is_in_grain(), expected.depth > 0.0);
    }
    if (!found.is_in_grain()) ++in_film;
  }
  return static_cast<double>(in_film) / static_cast<double>(points);
}

TEST(GrainLocator, AgreesWithTheDefinition) {
  for (const auto walls : {Walls::periodic, Walls::hard}) {
    const auto plane = random_sites<2>({2.0, walls, diameters_of_ratio(200, 50.0), 3, 0, 1e-6});
    const double film = film_thickness(Tessellation<2>(plane), 0.7);
    EXPECT_NEAR(compare_with_definition(plane, film, 5000, 1), 0.3, 0.03);
    const auto space = random_sites<3>({2.0, walls, diameters_of_ratio(50, 10.0), 3, 0, 1e-6});
    const double film_in_space = film_thickness(Tessellation<3>(space), 0.7);
    EXPECT_NEAR(compare_with_definition(space, film_in_space, 1000, 1), 0.3, 0.05);
  }
}

TEST(GrainLocator, FewGrainsMeetTheirOwnImages) {
  compare_with_definition<2>({1.0, Walls::periodic, {{{0.9, 0.05}, 0.0}}}, 0.2, 500, 3);
  compare_with_definition<2>({1.0, Walls::periodic, {{{0.9, 0.05}, 0.15}, {{0.4, 0.5}, 0.0}}}, 0.1, 1000, 3);
  compare_with_definition<2>({1.0, Walls::periodic, {{{0.0, 0.0}, 0.2}, {{0.95, 0.5}, 0.0}, {{0.5, 1.0}, 0.2}}}, 0.1,
                             1000, 3);
  compare_with_definition<3>({1.0, Walls::periodic, {{{0.9, 0.05, 0.5}, 0.3}, {{0.4, 0.5, 0.9}, 0.0}}}, 0.1, 500, 3);
}

// Tests points along the normal of a face, where no other face is near: the film ends t/2 from the face on both sides.
template <int dim>
void expect_exact_films(const LaguerreSites<dim>& sites, double film) {
  const Tessellation<dim> tessellation(sites);
  const GrainLocator<dim> locator(tessellation, film);
  const double roundoff = 1e-14 * sites.side;
  std::size_t tried = 0;
  for (const auto& point : random_points<dim>(3000, sites.side, 5)) {
    const auto [site, depth, nearest_film] = locator.at(point);
    // The nearest face, relative to the image of the site to which the point belongs.
    const auto& faces = tessellation.cell(site).half_spaces();
    Vector<dim> seen = point;
    for (std::size_t axis = 0; axis < dim; ++axis) {
      seen[axis] -= sites.sites[site].position[axis];
      seen[axis] -= sites.side * std::round(seen[axis] / sites.side);
    }
    const auto height = [&](const HalfSpace<dim>& face) { return -face.height(seen); };
    const auto& nearest = *std::ranges::min_element(faces, {}, height);
    const double to_face = height(nearest);
    if (std::abs(to_face - 0.5 * film - depth) > roundoff) continue;  // another image
    EXPECT_EQ(&faces[nearest_film], &nearest);
    const auto at = [&](double beyond) {
      Vector<dim> moved = point;
      for (std::size_t axis = 0; axis < dim; ++axis) moved[axis] += nearest.normal[axis] * (to_face + beyond);
      return locator.at(moved);
    };
    const auto own = at(-film);
    const auto other = at(film);
    if (std::abs(own.depth - 0.5 * film) > roundoff || std::abs(other.depth - 0.5 * film) > roundoff) continue;
    ++tried;
    EXPECT_EQ(own.site, site);
    EXPECT_EQ(other.site, Tessellation<dim>::neighbour(nearest));
    for (const double side : {-1.0, 1.0}) {
      EXPECT_FALSE(at(0.0).is_in_grain());
      EXPECT_FALSE(at(side * (0.5 * film - roundoff)).is_in_grain());
      EXPECT_TRUE(at(side * (0.5 * film + roundoff)).is_in_grain());
      EXPECT_NEAR(at(side * 0.3 * film).depth, -0.2 * film, roundoff);
      EXPECT_NEAR(at(side * 0.8 * film).depth, 0.3 * film, roundoff);
    }
  }
  EXPECT_GT(tried, 1000);
}

TEST(GrainLocator, FilmsAreExactlyAsThickAsAsked) {
  expect_exact_films<2>(random_sites<2>({1.0, Walls::periodic, diameters_of_ratio(100, 10.0), 8, 2, 1e-9}), 0.004);
  expect_exact_films<3>(random_sites<3>({1.0, Walls::periodic, diameters_of_ratio(50, 3.0), 8, 2, 1e-9}), 0.01);
}

void expect_depths_of_balls_that_hold_nothing_else(const LaguerreSites<2>& sites) {
  const GrainLocator<2> locator(Tessellation<2>(sites), 0.02);
  const auto directions = random_points<2>(8, 1.0, 3);
  for (const auto& point : random_points<2>(2000, 1.0, 2)) {
    const auto here = locator.at(point);
    for (const auto& direction : directions) {
      const double length = std::hypot(direction[0] - 0.5, direction[1] - 0.5);
      const double step = 0.999999 * std::abs(here.depth) / length;
      const auto there = locator.at({point[0] + step * (direction[0] - 0.5), point[1] + step * (direction[1] - 0.5)});
      EXPECT_EQ(there.is_in_grain(), here.is_in_grain());
      if (here.is_in_grain()) {
        EXPECT_EQ(there.site, here.site);
      }
    }
  }
}

TEST(GrainLocator, ABallOfTheDepthHoldsNothingElse) {
  auto sites = random_sites<2>({1.0, Walls::periodic, diameters_of_ratio(50, 10.0), 6, 1, 1e-9});
  expect_depths_of_balls_that_hold_nothing_else(sites);
  for (std::size_t site = 0; site < sites.sites.size(); ++site) sites.film_shares.push_back(site % 3 == 0 ? 0.1 : 1.2);
  expect_depths_of_balls_that_hold_nothing_else(sites);
}

TEST(GrainLocator, FindsTheGrainsOfFilmsOfSeveralThicknesses) {
  auto sites = random_sites<2>({1.0, Walls::periodic, diameters_of_ratio(50, 5.0), 6, 1, 1e-9});
  for (std::size_t site = 0; site < sites.sites.size(); ++site) sites.film_shares.push_back(site % 2 == 0 ? 0.3 : 2.0);
  const Tessellation<2> tessellation(sites);
  const double film = film_thickness(tessellation, 0.6);
  const GrainLocator<2> locator(tessellation, film);
  std::vector<ConvexCell<2>> grains;
  for (std::size_t site = 0; site < tessellation.size(); ++site) grains.push_back(tessellation.grain(site, film));
  std::size_t in_grains = 0;
  constexpr std::size_t points = 50000;
  for (const auto& point : random_points<2>(points, 1.0, 4)) {
    const auto found = locator.at(point);
    if (!found.is_in_grain()) continue;
    ++in_grains;
    const auto& site = sites.sites[found.site].position;
    double outside = -1.0;  // largest height above a face of the grain, relative to the nearest image of its site
    for (const auto& face : grains[found.site].half_spaces()) {
      const Vector<2> seen = {std::remainder(point[0] - site[0], 1.0), std::remainder(point[1] - site[1], 1.0)};
      outside = std::max(outside, face.height(seen));
    }
    EXPECT_LE(outside, 1e-12);
  }
  EXPECT_NEAR(static_cast<double>(in_grains) / points, 0.6, 0.01);
}

TEST(GrainLocator, APeriodicTessellationContinues) {
  const auto sites = random_sites<2>({1.0, Walls::periodic, diameters_of_ratio(30, 5.0), 6, 1, 1e-9});
  const GrainLocator<2> locator(Tessellation<2>(sites), 0.02);
  for (const auto& [x, y] : random_points<2>(300, 1.0, 2)) {
    const auto here = locator.at({x, y});
    const auto there = locator.at({x - 3.0, y + 1.0});
    EXPECT_EQ(there.site, here.site);
    EXPECT_NEAR(there.depth, here.depth, 1e-14);
  }
}

TEST(GrainLocator, HardWalls) {
  const Tessellation<2> tessellation({1.0, Walls::hard, {{{0.25, 0.5}, 0.0}, {{0.75, 0.5}, 0.0}}});
  const GrainLocator<2> locator(tessellation, 0.1);
  EXPECT_NEAR(locator.at({0.2, 0.5}).depth, 0.15, 1e-15);
  EXPECT_NEAR(locator.at({0.01, 0.5}).depth, -0.04, 1e-15);
  EXPECT_NEAR(locator.at({0.49, 0.5}).depth, -0.04, 1e-15);
  EXPECT_FALSE(locator.at({1.2, 0.5}).is_in_grain());
}

TEST(GrainLocator, WithoutAFilmEverythingIsGrain) {
  const auto sites = random_sites<3>({1.0, Walls::periodic, diameters_of_ratio(30, 5.0), 6, 1, 1e-9});
  const GrainLocator<3> locator(Tessellation<3>(sites), 0.0);
  for (const auto& point : random_points<3>(1000, 1.0, 2)) EXPECT_TRUE(locator.at(point).is_in_grain());
  EXPECT_TRUE(
      GrainLocator<2>(Tessellation<2>({1.0, Walls::periodic, {{{0.5, 0.5}, 0.0}}}), 0.0).at({0.0, 0.0}).is_in_grain());
}

TEST(GrainLocator, AThickFilmLeavesNoGrain) {
  const auto sites = random_sites<2>({1.0, Walls::periodic, diameters_of_ratio(30, 5.0), 6, 1, 1e-9});
  const GrainLocator<2> locator(Tessellation<2>(sites), 1.0);
  for (const auto& point : random_points<2>(300, 1.0, 2)) EXPECT_FALSE(locator.at(point).is_in_grain());
}

TEST(GrainLocator, BadFilms) {
  const Tessellation<2> tessellation({1.0, Walls::periodic, {{{0.5, 0.5}, 0.0}}});
  for (const double film : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    expect_error<InputError>(
        [&] {
          return GrainLocator<2>(tessellation, film).at({0.0, 0.0});
        },
        "thickness of the film");
  }
}

}  // namespace
}  // namespace breccia

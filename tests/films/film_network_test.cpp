#include "films/mesh/film_network.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <gmock/gmock.h>

#include "breccia/microstructure/random_sites.hpp"

#include "films/grains_and_films.hpp"

namespace breccia::films {
namespace {

/// Area of grains, films and junctions.
double whole_area(const FilmNetwork& network) {
  double sum = 0.0;
  for (const auto& grain : network.grains) sum += area(grain.corners);
  for (const auto& film : network.films) {
    double length = 0.0;
    for (const auto& side : film.sides) {
      length += (network.position(side.end) - network.position(side.begin)).dot(film.direction);
    }
    sum += 0.5 * length * film.thickness;
  }
  for (const auto& junction : network.junctions) {
    std::vector<Eigen::Vector2d> corners;
    for (const auto& corner : junction.corners) corners.push_back(network.position(corner));
    sum += area(corners);
  }
  return sum;
}

/// Equal square grains in rows and columns.
Tessellation<2> square_grains(Walls walls) {
  LaguerreSites<2> sites{3.0, walls, {}};
  for (const double x : {0.5, 1.5, 2.5}) {
    for (const double y : {0.5, 1.5, 2.5}) sites.sites.push_back({{x, y}, 0.0});
  }
  return Tessellation<2>(sites);
}

// By Euler's formula on a torus there are three films and two junctions for each grain.
TEST(FilmNetwork, OfPeriodicGrainsHasThreeFilmsAndTwoJunctionsAGrain) {
  const auto network = film_network(test::voronoi_problem().tessellation, 0.001, 0.3);
  EXPECT_EQ(network.films.size(), 75U);
  EXPECT_EQ(network.junctions.size(), 50U);
  for (const auto& junction : network.junctions) EXPECT_EQ(junction.corners.size(), 3U);
  for (const auto& film : network.films) EXPECT_NEAR(film.thickness, 0.001, 1e-12);
}

// At the largest thickness some faces have vanished on one side or on both.
TEST(FilmNetwork, TilesTheBox) {
  for (const auto boundary : test::all_boundaries) {
    const auto tessellation = test::voronoi_problem(boundary).tessellation;
    for (const double thickness : {1e-4, 0.0046875, 0.009375, 0.01875, 0.03}) {
      EXPECT_NEAR(whole_area(film_network(tessellation, thickness, 0.3)), 1.0, 1e-12) << thickness;
    }
  }
}

TEST(FilmNetwork, TilesTheBoxWithGrainsOfManySizes) {
  RandomTessellationRequest request{.side = 2.0, .walls = Walls::hard, .diameters = {}, .seed = 4};
  for (int i = 0; i < 60; ++i) request.diameters.push_back(i < 10 ? 5.0 : 1.0);
  for (const auto walls : {Walls::hard, Walls::periodic}) {
    request.walls = walls;
    const Tessellation<2> tessellation(random_sites<2>(request));
    EXPECT_NEAR(whole_area(film_network(tessellation, 0.5 * film_thickness(tessellation, 0.9), 0.3)), 1.0, 1e-12);
  }
}

TEST(FilmNetwork, JoinsTheJunctionsOfAFilmWithoutFaces) {
  const auto thin = film_network(test::voronoi_problem().tessellation, 0.001, 0.3);
  const auto thick = film_network(test::voronoi_problem().tessellation, 0.03, 0.3);
  const auto vanished = thin.films.size() - thick.films.size();
  EXPECT_GT(vanished, 0U);
  EXPECT_EQ(thin.junctions.size() - thick.junctions.size(), vanished);
  EXPECT_TRUE(std::ranges::any_of(thick.films, [](const Film& film) { return !film.sides[1].face; }));
}

TEST(FilmNetwork, KnowsJunctionsOfFourFilms) {
  const auto network = film_network(square_grains(Walls::periodic), 0.1 / 3.0, 0.3);
  EXPECT_EQ(network.films.size(), 18U);
  ASSERT_EQ(network.junctions.size(), 9U);
  for (const auto& junction : network.junctions) EXPECT_EQ(junction.corners.size(), 4U);
  EXPECT_NEAR(whole_area(network), 1.0, 1e-12);
}

TEST(FilmNetwork, EndsFilmsAtTheWalls) {
  const auto network = film_network(square_grains(Walls::hard), 0.1 / 3.0, 0.3);
  EXPECT_EQ(network.films.size(), 12U);
  EXPECT_EQ(std::ranges::count_if(network.junctions, &Junction::is_at_wall), 8);
  EXPECT_EQ(network.junctions.size(), 12U);
  EXPECT_NEAR(whole_area(network), 1.0, 1e-12);
}

}  // namespace
}  // namespace breccia::films

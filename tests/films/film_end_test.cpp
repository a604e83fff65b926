// Tests of the ends of films against Stokes flow in junctions of three channels (tests/reference/film_end.py), solved
// by Taylor-Hood elements without Breccia.

#include "films/assembly/film_end.hpp"

#include <array>
#include <numeric>

#include <gtest/gtest.h>

#include "films/grains_and_films.hpp"

namespace breccia::films {
namespace {

/// The angles between three channels [degrees], from the first to the second, on to the third, and back to the first.
struct StokesJunction {
  std::array<double, 3> angles, lengths;
};

TEST(FilmEnd, IsThatOfStokesFlowAtAnyAngles) {
  for (const auto& [angles, lengths] : {StokesJunction{{120, 120, 120}, {0.2311, 0.2311, 0.2311}},
                                        StokesJunction{{75, 138, 147}, {0.1906, 0.2173, 0.2022}},
                                        StokesJunction{{82, 117, 161}, {0.1622, 0.2836, 0.1848}},
                                        StokesJunction{{96, 96, 168}, {0.1612, 0.3209, 0.1587}},
                                        StokesJunction{{103, 124, 133}, {0.2278, 0.2476, 0.2081}},
                                        StokesJunction{{110, 117, 133}, {0.2215, 0.2523, 0.2145}}}) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(end_length({angles[(k + 2) % 3], angles[k]}), lengths[k], 5e-3) << angles[0] << ", channel " << k + 1;
    }
  }
}

TEST(FilmEnd, DoesNotDependOnTheOrderOfTheAnglesBesideIt) {
  EXPECT_EQ(end_length({95.0, 140.0}), end_length({140.0, 95.0}));
}

TEST(FilmEnds, WhereFourMeetAreThoseOfEvenAngles) {
  // In a square lattice four films meet in each junction.
  Tessellation<2> squares({.side = 1.0, .sites = {{{0.25, 0.25}}, {{0.75, 0.25}}, {{0.25, 0.75}}, {{0.75, 0.75}}}});
  for (const auto& ends : end_lengths(film_network(squares, 0.01, 0.3))) {
    EXPECT_EQ(ends[0], end_length({120.0, 120.0}));
    EXPECT_EQ(ends[1], end_length({120.0, 120.0}));
  }
}

TEST(FilmEnds, OfVoronoiGrainsHaveTheMeanOfTheirJunctions) {
  const auto problem = test::voronoi_problem();
  const auto lengths = end_lengths(film_network(problem.tessellation, problem.thickness, 0.3));
  double sum = 0.0;
  for (const auto& [begin, end] : lengths) sum += begin + end;
  const double mean = sum / (2.0 * static_cast<double>(lengths.size()));
  EXPECT_NEAR(mean / end_length({120.0, 120.0}), 0.970, 5e-3) << "by Stokes flow in 50 junctions, on coarser elements";
}

}  // namespace
}  // namespace breccia::films

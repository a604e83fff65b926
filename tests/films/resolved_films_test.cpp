// Films that are resolved by layers of elements.

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "breccia/films/film_moduli.hpp"

#include "film_composite.hpp"
#include "films/grains_and_films.hpp"

namespace breccia::films {
namespace {

using test::all_boundaries;
using test::all_loads;

FilmProblem with_layers(FilmProblem problem, int layers) {
  problem.layers = layers;
  return problem;
}

double modulus_of(const Moduli& moduli, Load load) {
  return load == Load::bulk ? moduli.bulk + moduli.shear / 3.0 : moduli.shear;
}

// A binder like the grains makes one material of the box, under any boundary; the elements fill it without gaps. With
// the thicker films faces have vanished.
TEST(ResolvedFilms, PassThePatchTest) {
  for (const auto boundary : all_boundaries) {
    for (const double thickness : {test::film_of_25, 0.03}) {
      const auto problem = with_layers(test::voronoi_problem(boundary, thickness), 2);
      EXPECT_NEAR(FilmOperator(problem).area(), 1.0, 1e-12);
      const auto moduli = film_moduli(problem, std::array{test::hmx}, all_loads).front();
      for (std::size_t l = 0; l < all_loads.size(); ++l) {
        EXPECT_NEAR(moduli[l] / modulus_of(test::hmx, all_loads[l]), 1.0, 1e-10) << name_of(boundary) << thickness;
      }
    }
  }
}

}  // namespace
}  // namespace breccia::films

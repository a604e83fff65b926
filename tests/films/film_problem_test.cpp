#include "breccia/films/film_problem.hpp"

#include <array>
#include <limits>

#include <gmock/gmock.h>

#include "breccia/error.hpp"
#include "breccia/films/film_moduli.hpp"

#include "films/film_sampling.hpp"
#include "films/grains_and_films.hpp"
#include "microstructure/expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;

TEST(FilmProblem, TellsEveryMistake) {
  auto problem = test::voronoi_problem();
  EXPECT_NO_THROW(require_sound(problem));
  problem.boundary = Boundary::traction;
  problem.thickness = 0.0;
  problem.grain.shear = -1.0;
  problem.elements.face_share = std::numeric_limits<double>::quiet_NaN();
  problem.layers = 0;
  expect_error<InputError>([&] { require_sound(problem); }, "thickness", "got 0 m", "shear modulus of the grains",
                           "got -1 Pa", "length of the elements", "layers across the films must be positive, got 0",
                           "periodic tessellation", "traction boundary");
  expect_error<InputError>(
      [] {
        auto walled = test::voronoi_problem(Boundary::displacement);
        walled.boundary = Boundary::periodic;
        require_sound(walled);
      },
      "walled tessellation", "periodic boundary");
}

TEST(FilmProblem, RefusesAFilmThatLeavesNothingOfAGrain) {
  const auto problem = test::voronoi_problem(Boundary::periodic, 0.2);
  expect_error<InputError>([&] { static_cast<void>(film_moduli(problem, std::array{test::hmx}, test::all_loads)); },
                           "0.2 m", "sites");
}

TEST(FilmProblem, RefusesABinderWithoutAModulus) {
  const Moduli none = {.bulk = 1e9, .shear = 0.0};
  expect_error<InputError>(
      [&] { static_cast<void>(film_moduli(test::voronoi_problem(), std::array{none}, test::all_loads)); },
      "binder must be positive", "G = 0 Pa");
}

TEST(FilmProblem, RefusesToSampleNothing) {
  const auto problem = test::voronoi_problem();
  expect_error<InputError>([&] { static_cast<void>(sample_film_responses(problem, test::all_loads, {})); },
                           "no moduli");
  expect_error<InputError>([&] { static_cast<void>(sample_film_responses(problem, {}, std::array{test::hmx})); },
                           "no loads");
}

}  // namespace
}  // namespace breccia

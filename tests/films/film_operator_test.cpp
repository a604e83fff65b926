#include "films/assembly/film_operator.hpp"

#include <array>

#include <gtest/gtest.h>

#include "breccia/films/film_moduli.hpp"

#include "films/film_composite.hpp"
#include "films/grains_and_films.hpp"

namespace breccia::films {
namespace {

using test::all_boundaries;
using test::all_loads;

// If the binder has the moduli of the grains, the box is homogeneous.
TEST(FilmOperator, PassesThePatchTest) {
  for (const auto boundary : {Boundary::periodic, Boundary::displacement}) {
    for (const double thickness : {test::film_of_25, 0.03}) {
      const auto moduli =
          film_moduli(test::voronoi_problem(boundary, thickness), std::array{test::hmx}, all_loads).front();
      for (std::size_t l = 0; l < all_loads.size(); ++l) {
        EXPECT_NEAR(moduli[l] / test::modulus_of(test::hmx, all_loads[l]), 1.0, 1e-11);
      }
    }
  }
}

// Where a film ends at a wall with a given traction, the deviator of this traction works on the flow there, which no
// stress in the film opposes: of the order of (t/L)^2 of the few films there. The slip of an opening has the compliance
// 0.12 to 0.2 t^2/G, as if the grains beside it were rigid: 2 to 3 10^-4 for the twenty openings here.
TEST(FilmOperator, AlmostPassesThePatchTestUnderTractions) {
  const auto moduli = film_moduli(test::voronoi_problem(Boundary::traction), std::array{test::hmx}, all_loads).front();
  for (std::size_t l = 0; l < all_loads.size(); ++l) {
    EXPECT_NEAR(moduli[l] / test::modulus_of(test::hmx, all_loads[l]), 1.0, 4e-4);
  }
}

TEST(FilmOperator, GivesTheVoigtModulusForTheUniformStrain) {
  for (const auto boundary : all_boundaries) {
    const FilmComposite<2> composite(test::voronoi_problem(boundary));
    const auto& film_operator = composite.film_operator();
    EXPECT_NEAR(film_operator.content(), 1.0, 1e-12);
    const double fraction = grain_fraction(test::voronoi_problem().tessellation, test::film_of_25);
    for (const auto load : all_loads) {
      const auto uniform = composite.uniform_strain(load);
      const auto energy = [&](const FilmVector& forces) { return work(forces, uniform); };
      const bool is_bulk = load == Load::bulk;
      const double film_share = energy(film_operator.shear_forces(load, uniform)) / (is_bulk ? 1.0 / 3.0 : 1.0);
      EXPECT_NEAR(energy(film_operator.bulk_forces(load, uniform)), is_bulk ? film_share : 0.0, 1e-12);
      EXPECT_NEAR(energy(film_operator.grain_forces(load, uniform)) / test::modulus_of(test::hmx, load),
                  1.0 - film_share, 1e-12);
      if (boundary == Boundary::periodic) {
        EXPECT_NEAR(1.0 - film_share, fraction, 1e-12);
      }
    }
  }
}

// The energy is affine in the moduli of the binder, so its derivatives at a solution are those of the modulus.
TEST(FilmOperator, HasTheDerivativesOfTheModulusAsItsParts) {
  constexpr double step = 1e-4;
  for (const auto boundary : all_boundaries) {
    const FilmComposite<2> composite(test::voronoi_problem(boundary));
    FilmSolver<2> solver(composite);
    const std::array binder = {1e7, test::binder_bulk};
    const auto modulus_at = [&](double shear_factor, double bulk_factor) {
      solver.prepare(std::array{shear_factor * binder[0], bulk_factor * binder[1]});
      return solver.modulus(Load::shear, solver.solve(Load::shear, composite.zero()));
    };
    const std::array differences = {modulus_at(1.0 + step, 1.0) - modulus_at(1.0 - step, 1.0),
                                    modulus_at(1.0, 1.0 + step) - modulus_at(1.0, 1.0 - step)};
    const double modulus = modulus_at(1.0, 1.0);
    const auto solution = solver.solve(Load::shear, composite.zero());
    // Under a traction boundary the parts are derivatives of the compliance, with the opposite sign.
    const double scale = boundary == Boundary::traction ? modulus * modulus : 1.0;
    for (std::size_t part = 0; part < binder.size(); ++part) {
      const double energy = work(composite.part_forces(part, Load::shear, solution), solution);
      EXPECT_NEAR(differences[part] / (2.0 * step * binder[part]) / (scale * energy), 1.0, 1e-5) << part;
    }
  }
}

// The held nodes of a traction boundary feel no force.
TEST(FilmOperator, IsInEquilibriumUnderTractions) {
  const FilmOperator<2> film_operator(test::voronoi_problem(Boundary::traction));
  for (const auto load : all_loads) {
    const auto forces = film_operator.load_forces(load);
    EXPECT_NEAR(work(forces, film_operator.uniform_strain(load)), 1.0, 1e-12);
  }
}

TEST(FilmModuli, OfAWindowAreOrderedByTheBoundary) {
  for (const double shear : {1e8, 1e6}) {
    const std::array binder = {Moduli{test::binder_bulk, shear}};
    const auto upper = film_moduli(test::voronoi_problem(Boundary::displacement), binder, all_loads).front();
    const auto lower = film_moduli(test::voronoi_problem(Boundary::traction), binder, all_loads).front();
    for (std::size_t l = 0; l < all_loads.size(); ++l) EXPECT_GT(upper[l], lower[l]);
  }
}

}  // namespace
}  // namespace breccia::films

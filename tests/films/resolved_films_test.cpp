// Tests of films that are resolved by layers of elements.

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "breccia/films/film_moduli.hpp"
#include "breccia/quasistatic/apparent_moduli.hpp"

#include "discretisation/grain_cells.hpp"
#include "films/film_composite.hpp"
#include "films/film_sampling.hpp"
#include "films/grains_and_films.hpp"
#include "tables/csv.hpp"

namespace breccia::films {
namespace {

using test::all_boundaries;
using test::all_loads;
using test::modulus_of;

FilmProblem<2> with_layers(FilmProblem<2> problem, int layers) {
  problem.layers = layers;
  return problem;
}

void expect_one_material(const FilmProblem<2>& problem) {
  EXPECT_NEAR(FilmOperator<2>(problem).content(), 1.0, 1e-12);
  const auto moduli = film_moduli(problem, std::array{test::hmx}, all_loads).front();
  for (std::size_t l = 0; l < all_loads.size(); ++l) {
    EXPECT_NEAR(moduli[l] / modulus_of(test::hmx, all_loads[l]), 1.0, 1e-10) << name_of(problem.boundary);
  }
}

// If the binder has the moduli of the grains, the box is homogeneous, and the elements fill it without gaps.
TEST(ResolvedFilms, PassThePatchTest) {
  for (const auto boundary : all_boundaries) expect_one_material(with_layers(test::voronoi_problem(boundary), 2));
}

TEST(ResolvedFilms, PassThePatchTestWhereFacesHaveVanished) {
  for (const auto boundary : all_boundaries) {
    expect_one_material(with_layers(test::voronoi_problem(boundary, 0.03), 1));
  }
}

// Two grains in a box with walls and the film between them, under uniform shear tractions: the compliances add up.
TEST(ResolvedFilms, AreExactForALaminateInShear) {
  constexpr double thickness = 0.02;
  const FilmProblem<2> two_grains = {
      .tessellation = Tessellation<2>({.side = 1.0, .walls = Walls::hard, .sites = {{{0.2, 0.5}}, {{0.8, 0.5}}}}),
      .thickness = thickness,
      .grain = test::hmx,
      .boundary = Boundary::traction,
      .layers = 3};
  const Moduli binder = {.bulk = test::binder_bulk, .shear = 1e7};
  const double found = film_moduli(two_grains, std::array{binder}, std::array{Load::shear}).front().front();
  const double compliance = (1.0 - thickness) / test::hmx.shear + thickness / binder.shear;
  EXPECT_NEAR(found * compliance, 1.0, 1e-10);
}

/// The 25 grains with films from half to three times as thick as the thinnest, by pairs of grains.
FilmProblem<2> with_several_thicknesses(Boundary boundary = Boundary::periodic) {
  auto sites = test::voronoi_sites_25();
  if (boundary != Boundary::periodic) sites.walls = Walls::hard;
  for (std::size_t site = 0; site < sites.sites.size(); ++site) {
    sites.film_shares.push_back(0.5 + 0.25 * static_cast<double>(site % 5));
  }
  return {.tessellation = Tessellation<2>(std::move(sites)),
          .thickness = test::film_of_25,
          .grain = test::hmx,
          .boundary = boundary};
}

TEST(FilmsOfSeveralThicknesses, PassThePatchTest) {
  for (const auto boundary : all_boundaries) {
    expect_one_material(with_layers(with_several_thicknesses(boundary), 2));
    EXPECT_NEAR(FilmOperator<2>(with_several_thicknesses(boundary)).content(), 1.0, 1e-12);
  }
}

// Thin films are compared with layers of elements, at moduli of the binder from stiff to soft.
TEST(FilmsOfSeveralThicknesses, AreThoseThatLayersResolve) {
  const std::array binders = {Moduli{test::binder_bulk, 5e8}, Moduli{test::binder_bulk, 3e7},
                              Moduli{test::binder_bulk, 7e5}};
  const auto resolved = film_moduli(with_layers(with_several_thicknesses(), 2), binders, all_loads);
  const auto thin = film_moduli(with_several_thicknesses(), binders, all_loads);
  for (std::size_t b = 0; b < binders.size(); ++b) {
    for (std::size_t l = 0; l < all_loads.size(); ++l) {
      EXPECT_NEAR(thin[b][l] / resolved[b][l], 1.0, 0.012) << binders[b].shear << " " << name_of(all_loads[l]);
    }
  }
}

// The test is for windows under tractions: without the slip of the openings (Eq. 63b) thin films are several per cent
// too stiff.
TEST(ThinFilms, OpenInWallsUnderTractionsAsLayersDo) {
  const std::array binder = {Moduli{test::binder_bulk, 1e6}};
  const auto problem = test::voronoi_problem(Boundary::traction);
  const auto resolved = film_moduli(with_layers(problem, 2), binder, all_loads).front();
  const auto thin = film_moduli(problem, binder, all_loads).front();
  for (std::size_t l = 0; l < all_loads.size(); ++l) {
    EXPECT_NEAR(thin[l] / resolved[l], 1.0, 0.015) << name_of(all_loads[l]);
  }
}

// Mixed cells of the same grains have similar errors with films of one thickness and of several.
TEST(FilmsOfSeveralThicknesses, ChangeTheModuliOfCellsAsMuch) {
  const auto by_cells = [](const FilmProblem<2>& problem) {
    const Material grain = {"hmx", 1850.0, PronySeries(test::hmx.bulk), PronySeries(test::hmx.shear)};
    const Material binder = {"binder", 1480.0, PronySeries(test::binder_bulk), PronySeries(1e7)};
    return apparent_moduli<2>(
        {.discretisation = discretise_mixed(problem.tessellation, problem.thickness, 256, 0, 1, 2),
         .materials = {binder, grain},
         .boundary = Boundary::periodic,
         .linear = {.tolerance = 1e-7, .threads = 1}},
        all_loads);
  };
  const std::array binder = {Moduli{test::binder_bulk, 1e7}};
  const auto equal = test::voronoi_problem(), several = with_several_thicknesses();
  const auto of_equal = by_cells(equal), of_several = by_cells(several);
  const auto films_of_equal = film_moduli(equal, binder, all_loads).front();
  const auto films_of_several = film_moduli(several, binder, all_loads).front();
  for (std::size_t l = 0; l < all_loads.size(); ++l) {
    EXPECT_NEAR(films_of_several[l] / films_of_equal[l], of_several[l] / of_equal[l], 0.01) << name_of(all_loads[l]);
  }
  EXPECT_GT(of_several[1] / of_equal[1], 1.008) << "the shares matter under the shear of the diagonals";
}

// The reference has triangles of another mesh and program and is converged to 0.1 %.
TEST(ResolvedFilms, MeetAnIndependentSolution) {
  const auto table = read_csv(BRECCIA_REFERENCE_DIRECTORY "/voronoi_films.csv", {"load"});
  constexpr double mega = 1e6;
  FilmComposite<2> composite(with_layers(test::voronoi_problem(), 4));
  FilmSolver<2> solver(composite);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double shear = table.numbers("binder_shear_MPa")[row];
    if (shear != 500.0 && shear != 30.0 && shear != 0.7) continue;
    const auto name = table.text("load")[row];
    const auto load = name == "xy" ? Load::shear : name == "xx-yy" ? Load::diagonal_shear : Load::bulk;
    solver.prepare(std::array{mega * shear, test::binder_bulk});
    const double found = solver.modulus(load, solver.solve(load, composite.zero())) / mega;
    EXPECT_NEAR(found / table.numbers("modulus_MPa")[row], 1.0, load == Load::bulk ? 1e-4 : 1.5e-3) << shear << name;
  }
}

TEST(ResolvedFilms, AreOrderedByTheBoundary) {
  const std::array binder = {Moduli{test::binder_bulk, 1e7}};
  const auto upper = film_moduli(with_layers(test::voronoi_problem(Boundary::displacement), 1), binder, all_loads);
  const auto lower = film_moduli(with_layers(test::voronoi_problem(Boundary::traction), 1), binder, all_loads);
  for (std::size_t l = 0; l < all_loads.size(); ++l) EXPECT_GT(upper.front()[l], lower.front()[l]);
}

// The reduced basis works for resolved films as for thin ones.
TEST(ResolvedFilms, HaveAReducedResponse) {
  const auto problem = with_layers(test::voronoi_problem(), 1);
  const std::array path = {Moduli{test::binder_bulk, 1e8}, Moduli{test::binder_bulk, 3e7},
                           Moduli{test::binder_bulk, 1e7}};
  const auto sampled = sample_film_responses(problem, std::array{Load::shear}, path, {.tolerance = 1e-6});
  const std::array between = {Moduli{test::binder_bulk, 2e7}};
  const double direct = film_moduli(problem, between, std::array{Load::shear}).front().front();
  EXPECT_NEAR(sampled.responses.front().modulus(between.front()) / direct, 1.0, 1e-4);
}

}  // namespace
}  // namespace breccia::films

#include "films/film_stepping.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/films/film_moduli.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "films/film_sampling.hpp"
#include "films/grains_and_films.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/carson_path.hpp"

namespace breccia {
namespace {

using test::all_boundaries;
using test::all_loads;

/// Five grains of unlike sizes, with few elements.
FilmProblem<2> five_grains(Boundary boundary) {
  LaguerreSites<2> sites;
  sites.side = 1e-3;
  sites.walls = boundary == Boundary::periodic ? Walls::periodic : Walls::hard;
  for (const auto& [x, y] : {std::array{0.12, 0.18}, {0.62, 0.21}, {0.36, 0.52}, {0.86, 0.68}, {0.31, 0.88}}) {
    sites.sites.push_back({{1e-3 * x, 1e-3 * y}, 0.0});
  }
  return {.tessellation = Tessellation<2>(std::move(sites)),
          .thickness = 1e-5,
          .grain = test::hmx,
          .boundary = boundary,
          .elements = {.face_share = 0.5}};
}

// Both methods integrate the same network of springs and dashpots: one by time steps, the other exactly in a basis of a
// few elastic solutions.
TEST(FilmStepping, MeetsTheReducedResponse) {
  const auto material = test::relaxing_binder();
  constexpr int per_decade = 40;
  const auto times = test::logarithmic(1e-9, 1e1, per_decade);
  const auto path = carson_path(material, {1e-8, 1e1});
  for (const auto boundary : all_boundaries) {
    const auto problem = five_grains(boundary);
    const auto stepped = run_film_stepping(problem, material, all_loads, times);
    const auto sampled = sample_film_responses(problem, all_loads, path);
    for (std::size_t l = 0; l < all_loads.size(); ++l) {
      SCOPED_TRACE(std::string(name_of(boundary)) + " " + std::string(name_of(all_loads[l])));
      const auto compliance = creep_compliance(sampled.responses[l], material);
      const auto modulus = relaxation_modulus(compliance);
      for (std::size_t i = per_decade; i < times.size(); i += per_decade) {
        const double reduced = boundary == Boundary::traction ? compliance.at(times[i]) : modulus.at(times[i]);
        EXPECT_NEAR(stepped.responses[l].values[i] / reduced, 1.0, 1e-3) << times[i];
        EXPECT_LT(stepped.responses[l].error_estimates[i], 1e-3);
      }
    }
  }
}

TEST(FilmStepping, BeginsWithTheElasticModulusOfTheUnrelaxedBinder) {
  const auto material = test::relaxing_binder();
  const auto problem = five_grains(Boundary::periodic);
  const auto stepped = run_film_stepping(problem, material, all_loads, std::array{1e-9});
  const std::array unrelaxed = {Moduli{.bulk = material.bulk.unrelaxed(), .shear = material.shear.unrelaxed()}};
  const auto moduli = film_moduli(problem, unrelaxed, all_loads).front();
  for (std::size_t l = 0; l < all_loads.size(); ++l) {
    EXPECT_NEAR(stepped.responses[l].unrelaxed / moduli[l], 1.0, 1e-9);
  }
}

// The mean stress over the fields is the modulus at each kept time, and the fields are those of the reduced response.
TEST(FilmStepping, KeepsFields) {
  const auto material = test::relaxing_binder();
  const auto problem = five_grains(Boundary::periodic);
  const auto times = test::logarithmic(1e-9, 1e-2, 20);
  const std::array kept = {times[60], times.back()};
  const std::array loads = {Load::shear};
  const auto stepped = run_film_stepping(problem, material, loads, times, {}, kept);
  const auto sampled = sample_film_responses(problem, loads, carson_path(material, {1e-8, 1e-2}));
  ASSERT_EQ(stepped.fields.size(), kept.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    EXPECT_EQ(stepped.fields[k].time, kept[k]);
    const auto& fields = stepped.fields[k].fields;
    const auto reduced = sampled.fields(0, std::array{material}, kept[k]);
    double stress = 0.0, difference = 0.0, size = 0.0;
    ASSERT_EQ(fields.cells.size(), reduced.cells.size());
    for (std::size_t c = 0; c < fields.cells.size(); ++c) {
      const auto &one = fields.cells[c], &other = reduced.cells[c];
      stress += one.content * one.stress[3];
      difference += one.content * std::abs(one.stress[3] - other.stress[3]);
      size += one.content * std::abs(other.stress[3]);
    }
    const double box = problem.tessellation.side() * problem.tessellation.side();
    const auto index = std::ranges::find(times, kept[k]) - times.begin();
    EXPECT_NEAR(stress / box / stepped.responses[0].values[static_cast<std::size_t>(index)], 1.0, 1e-9);
    EXPECT_LT(difference / size, 5e-3);
  }
}

TEST(FilmStepping, RefusesWhatIsIncomplete) {
  const auto problem = five_grains(Boundary::periodic);
  const auto material = test::relaxing_binder();
  EXPECT_THROW(static_cast<void>(run_film_stepping(problem, material, all_loads, std::vector<double>{})), InputError);
  EXPECT_THROW(static_cast<void>(run_film_stepping(problem, material, {}, std::array{1.0})), InputError);
}

}  // namespace
}  // namespace breccia

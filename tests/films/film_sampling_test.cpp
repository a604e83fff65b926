#include "films/film_sampling.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "breccia/films/film_moduli.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "films/grains_and_films.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

/// The binder of PBX-9501, with 22 terms over 22 decades.
Material binder() {
  const auto table = read_csv(BRECCIA_DATA_DIRECTORY "/pbx9501_binder_prony.csv", {});
  std::vector<MaxwellTerm> terms;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    terms.push_back({table.numbers("relaxation_time_s")[row], table.numbers("shear_modulus_Pa")[row]});
  }
  return {"binder", 1480.0, PronySeries(test::binder_bulk), PronySeries(0.0, std::move(terms))};
}

const TimeWindow window = {1e-8, 1e2};

/// The Carson transform of a modulus [Pa].
double carson_transform(const PronySeries& series, double s) {
  return carson_moduli({"composite", 1.0, PronySeries(0.0), series}, s).shear;
}

// The curve in time and single elastic solutions agree at every real Laplace variable.
TEST(FilmSampling, GivesTheCurveOfTheBinderOfPbx9501) {
  const auto material = binder();
  const auto path = carson_path(material, window);
  for (const auto boundary : {Boundary::periodic, Boundary::displacement, Boundary::traction}) {
    const auto problem = test::voronoi_problem(boundary);
    const auto sampled = sample_film_responses(problem, test::all_loads, path);
    EXPECT_EQ(sampled.effort.solves, 3 * sampled.effort.factorisations);
    for (std::size_t l = 0; l < test::all_loads.size(); ++l) {
      const auto modulus = relaxation_modulus(creep_compliance(sampled.responses[l], material));
      for (const double time : {1e-8, 1e-6, 1e-4, 1e-2, 1.0, 1e2}) {
        const std::array at = {carson_moduli(material, 1.0 / time)};
        const double direct = film_moduli(problem, at, std::array{test::all_loads[l]}).front().front();
        EXPECT_NEAR(carson_transform(modulus, 1.0 / time) / direct, 1.0, 1e-4) << time;
        EXPECT_GT(sampled.responses[l].modulus(at.front()) / direct, 1.0 - 1e-8);  // the projection is stiffer
      }
    }
  }
}

// A window is stiffer under displacements than under tractions at every real Laplace variable, where the composite is
// elastic (Huet); so are single elastic solutions, their reduced responses, and the curves in time that these give.
TEST(FilmSampling, BoundsOfAWindowAreOrderedAtRealLaplaceVariables) {
  const auto material = binder();
  const auto path = carson_path(material, window);
  const auto upper_problem = test::voronoi_problem(Boundary::displacement);
  const auto lower_problem = test::voronoi_problem(Boundary::traction);
  const auto upper = sample_film_responses(upper_problem, test::all_loads, path).responses;
  const auto lower = sample_film_responses(lower_problem, test::all_loads, path).responses;
  for (std::size_t l = 0; l < test::all_loads.size(); ++l) {
    const std::array load = {test::all_loads[l]};
    const auto upper_curve = relaxation_modulus(creep_compliance(upper[l], material));
    const auto lower_curve = relaxation_modulus(creep_compliance(lower[l], material));
    for (const double time : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2}) {
      const std::array at = {carson_moduli(material, 1.0 / time)};
      EXPECT_GT(film_moduli(upper_problem, at, load).front().front(),
                film_moduli(lower_problem, at, load).front().front())
          << time;
      EXPECT_GT(upper[l].modulus(at.front()), lower[l].modulus(at.front())) << time;
      EXPECT_GT(carson_transform(upper_curve, 1.0 / time), carson_transform(lower_curve, 1.0 / time)) << time;
    }
  }
}

TEST(FilmSampling, NeedsNoMoreThanTheMiddleAndTheEndsOfAShortPath) {
  const std::array<Moduli, 2> path = {Moduli{test::binder_bulk, 1.01e7}, Moduli{test::binder_bulk, 1e7}};
  const auto sampled = sample_film_responses(test::voronoi_problem(), std::array{Load::shear}, path);
  EXPECT_LE(sampled.effort.factorisations, 3);
  EXPECT_EQ(sampled.responses.front().phases(), std::vector<std::string>{"matrix"});
}

}  // namespace
}  // namespace breccia

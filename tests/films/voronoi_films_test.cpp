// Tests of grains and films against conforming elements that resolve the films with six layers (tests/reference).

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/films/film_moduli.hpp"

#include "films/grains_and_films.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

constexpr double mega = 1e6;

/// The moduli [MPa] in the rows of the reference, and those of the model of films.
struct Comparison {
  double shear;  ///< shear modulus of the binder [MPa]
  std::string load;
  double reference, found;
};

std::vector<Comparison> compare(double face_share) {
  const auto table = read_csv(BRECCIA_REFERENCE_DIRECTORY "/voronoi_films.csv", {"load"});
  auto problem = test::voronoi_problem();
  problem.elements.face_share = face_share;
  std::vector<Moduli> binders;
  for (const double shear : table.numbers("binder_shear_MPa")) binders.push_back({test::binder_bulk, mega * shear});
  const auto moduli = film_moduli(problem, binders, test::all_loads);
  std::vector<Comparison> comparisons;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto load = table.text("load")[row];
    const std::size_t column = load == "xy" ? 0 : load == "xx-yy" ? 1 : 2;
    comparisons.push_back(
        {table.numbers("binder_shear_MPa")[row], load, table.numbers("modulus_MPa")[row], moduli[row][column] / mega});
  }
  return comparisons;
}

TEST(VoronoiFilms, AreWithinHalfAPerCentOfTheResolvedOnes) {
  for (const auto& [shear, load, reference, found] : compare(0.3)) {
    EXPECT_NEAR(found / reference, 1.0, load == "bulk" ? 5e-4 : 5e-3) << shear << " MPa, " << load;
  }
}

// The remaining error is of the order of (t/L)^2, 0.5 %, plus the reference's own 0.1 %.
TEST(VoronoiFilms, ConvergeToWithinHalfAPerCentAndTheErrorOfTheReference) {
  for (const auto& [shear, load, reference, found] : compare(0.1)) {
    EXPECT_NEAR(found / reference, 1.0, load == "bulk" ? 5e-4 : 6e-3) << shear << " MPa, " << load;
  }
}

// The expected moduli along the axes [MPa] for a binder of 0.7 MPa were computed with four layers across every film.
TEST(VoronoiFilms, OfOtherThicknessesErrMoreTheThickerTheFilms) {
  struct Case {
    double thickness, modulus, tolerance;
  };
  for (const auto& [thickness, modulus, tolerance] :
       {Case{0.0046875, 1043.9, 5e-3}, Case{0.009375, 272.9, 6e-3}, Case{0.01875, 44.2, 1.8e-2}}) {
    auto problem = test::voronoi_problem(Boundary::periodic, thickness);
    problem.elements.face_share = 0.15;
    const std::array binder = {Moduli{test::binder_bulk, 0.7 * mega}};
    const auto found = film_moduli(problem, binder, std::array{Load::shear}).front().front() / mega;
    EXPECT_NEAR(found / modulus, 1.0, tolerance) << thickness;
  }
}

}  // namespace
}  // namespace breccia

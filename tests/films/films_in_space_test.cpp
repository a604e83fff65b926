#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/films/film_moduli.hpp"

#include "films/film_composite.hpp"

namespace breccia::films {
namespace {

constexpr Moduli hmx = {.bulk = 13.4e9, .shear = 5.84e9};
constexpr double bulk_of_binder = 3.6e9;

/// Rhombic dodecahedra: the cells of the sites of a face-centred cubic lattice.
FilmProblem<3> rhombic_dodecahedra(double fraction, int divisions) {
  const LaguerreSites<3> sites = {
      .side = 1.0, .sites = {{{0.25, 0.25, 0.25}}, {{0.75, 0.75, 0.25}}, {{0.75, 0.25, 0.75}}, {{0.25, 0.75, 0.75}}}};
  const Tessellation<3> tessellation(sites);
  return {.tessellation = tessellation,
          .thickness = film_thickness(tessellation, fraction),
          .grain = hmx,
          .elements = {.divisions = divisions}};
}

TEST(FilmsInSpace, PassThePatchTest) {
  auto problem = rhombic_dodecahedra(0.93, 1);
  EXPECT_NEAR(FilmOperator<3>(problem).content(), 1.0, 1e-12);
  const auto moduli = film_moduli(problem, std::array{hmx}, std::array{Load::shear, Load::diagonal_shear, Load::bulk});
  EXPECT_NEAR(moduli[0][0] / hmx.shear, 1.0, 1e-10);
  EXPECT_NEAR(moduli[0][1] / hmx.shear, 1.0, 1e-10);
  EXPECT_NEAR(moduli[0][2] / hmx.bulk, 1.0, 1e-10);
}

TEST(FilmsInSpace, OfRhombicDodecahedraAreThoseOfThePrototype) {
  struct Row {
    double shear;                    ///< [Pa]
    std::array<double, 2> one, two;  ///< G_xy and G_xx-yy [MPa] with one and two elements an edge
  };
  constexpr std::array rows = {Row{1e9, {5028, 4870}, {5048, 4881}}, Row{1e8, {3869, 3020}, {3984, 3080}},
                               Row{1e7, {3191, 1959}, {3250, 1966}}, Row{1e6, {1907, 761}, {1913, 792}},
                               Row{1e5, {393, 110}, {400, 120}}};
  std::vector<Moduli> binders;
  for (const auto& row : rows) binders.push_back({.bulk = bulk_of_binder, .shear = row.shear});
  const std::array loads = {Load::shear, Load::diagonal_shear};
  const auto of_one = film_moduli(rhombic_dodecahedra(0.93, 1), binders, loads);
  const auto of_two = film_moduli(rhombic_dodecahedra(0.93, 2), binders, loads);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t load = 0; load < loads.size(); ++load) {
      EXPECT_NEAR(of_one[i][load] / (1e6 * rows[i].one[load]), 1.0, 5e-3) << rows[i].shear << ", load " << load;
      EXPECT_NEAR(of_two[i][load] / (1e6 * rows[i].two[load]), 1.0, 5e-3) << rows[i].shear << ", load " << load;
    }
  }
}

}  // namespace
}  // namespace breccia::films

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/films/film_moduli.hpp"
#include "breccia/microstructure/cell_faces.hpp"
#include "breccia/microstructure/random_sites.hpp"

#include "films/grains_and_films.hpp"
#include "films/stepped_response.hpp"
#include "microstructure/expect_error.hpp"

namespace breccia::films {
namespace {

using test::binder_bulk;

constexpr std::array loads = {Load::shear, Load::diagonal_shear, Load::bulk};

/// A problem with a share of its films debonded.
template <int dim>
FilmProblem<dim> debonded(FilmProblem<dim> problem, Debonding kind, double share) {
  problem.debonded = {kind, random_faces(problem.tessellation, share, 1).faces};
  return problem;
}

std::vector<double> moduli_of(const FilmProblem<2>& problem, double shear) {
  return film_moduli(problem, std::array{Moduli{.bulk = binder_bulk, .shear = shear}}, loads).front();
}

/// Hexagons, 15 of which fit on another along the second axis of a square box; they are regular within 0.04 %.
FilmProblem<2> hexagons(double length_over_thickness) {
  constexpr int columns = 26, pairs = 15;
  LaguerreSites<2> sites;
  sites.side = 1.0;
  for (int row = 0; row < 2 * pairs; ++row) {
    for (int column = 0; column < columns; ++column) {
      sites.sites.push_back({{(column + (row % 2 == 0 ? 0.25 : 0.75)) / columns, (row + 0.5) / (2.0 * pairs)}});
    }
  }
  // The distance of opposite faces is L = l sqrt(3) + t.
  const double distance = 1.0 / columns;
  return {.tessellation = Tessellation<2>(sites),
          .thickness = distance / (std::sqrt(3.0) * length_over_thickness + 1.0),
          .grain = {.bulk = 1e12, .shear = 1e12}};
}

/// G/g of rigid hexagons and thin films of an incompressible binder, with faces of length l: squeezing (Eq. 62), bends
/// (Eq. 63) and the shear of films and junctions.
double shear_of_hexagons(double l_over_t) {
  return std::sqrt(3.0) / 4.0 * (std::pow(l_over_t, 3) + 6.0 * 0.2319 * std::pow(l_over_t, 2) + 7.0 / 3.0 * l_over_t);
}

/// As shear_of_hexagons(), with films that slide: halves of films of twice the thickness, without a shear along them.
double shear_of_sliding_hexagons(double l_over_t) {
  return std::sqrt(3.0) / 4.0 * (0.25 * std::pow(l_over_t, 3) + 3.0 * 0.2319 * std::pow(l_over_t, 2));
}

TEST(Films, BetweenRigidHexagonsAreSqueezed) {
  for (const double l_over_t : {20.0, 60.0}) {
    const auto moduli = film_moduli(hexagons(l_over_t), std::array{Moduli{.bulk = 1e9, .shear = 1.0}},
                                    std::array{Load::shear, Load::diagonal_shear})
                            .front();
    for (const double modulus : moduli) EXPECT_NEAR(modulus / shear_of_hexagons(l_over_t), 1.0, 0.01) << l_over_t;
  }
}

TEST(DebondedFilms, ThatSlideAreSqueezedLikeHalvesOfFilmsOfTwiceTheThickness) {
  constexpr double l_over_t = 100.0;
  const auto problem = debonded(hexagons(l_over_t), Debonding::slip, 1.0);
  const auto moduli =
      film_moduli(problem, std::array{Moduli{.bulk = 1e9, .shear = 1.0}}, std::array{Load::shear, Load::diagonal_shear})
          .front();
  for (const double modulus : moduli) EXPECT_NEAR(modulus / shear_of_sliding_hexagons(l_over_t), 1.0, 0.01);
}

TEST(DebondedFilms, ThatSlideInSpaceAreSqueezedWithAQuarterOfTheForce) {
  const LaguerreSites<3> sites = {
      .side = 1.0, .sites = {{{0.25, 0.25, 0.25}}, {{0.75, 0.75, 0.25}}, {{0.75, 0.25, 0.75}}, {{0.25, 0.75, 0.75}}}};
  FilmProblem<3> problem = {.tessellation = Tessellation<3>(sites),
                            .thickness = 1e-3 * std::cbrt(0.25),
                            .grain = {.bulk = 1e11, .shear = 1e11},
                            .elements = {.divisions = 1}};
  const std::array binders = {Moduli{.bulk = 1e9, .shear = 1.0}};
  const std::array shears = {Load::shear, Load::diagonal_shear};
  const auto bonded = film_moduli(problem, binders, shears).front();
  const auto sliding = film_moduli(debonded(problem, Debonding::slip, 1.0), binders, shears).front();
  for (std::size_t i = 0; i < shears.size(); ++i) EXPECT_NEAR(sliding[i] / bonded[i], 0.25, 1e-3);
}

// Resolved films that are left out free the binder beside them, whose pressure the thin films set to zero.
TEST(DebondedFilms, ThatAreOpenAreCloseToResolvedOnes) {
  auto thin = debonded(test::voronoi_problem(), Debonding::open, 0.1), resolved = thin;
  resolved.layers = 3;
  for (const double shear : {1e9, 1e7, 1e5}) {
    const auto of_thin = moduli_of(thin, shear), of_resolved = moduli_of(resolved, shear);
    for (std::size_t i = 0; i < loads.size(); ++i) {
      EXPECT_NEAR(of_thin[i] / of_resolved[i], 1.0, loads[i] == Load::bulk ? 0.08 : 0.03) << shear << ", load " << i;
    }
  }
}

TEST(DebondedFilms, SoftenInTheirOrder) {
  const auto bonded = test::voronoi_problem();
  for (const double shear : {1e9, 1e7, 1e5}) {
    const auto of_bonded = moduli_of(bonded, shear);
    const auto of_sealed = moduli_of(debonded(bonded, Debonding::sealed, 0.2), shear);
    const auto of_open = moduli_of(debonded(bonded, Debonding::open, 0.2), shear);
    const auto of_slip = moduli_of(debonded(bonded, Debonding::slip, 0.2), shear);
    for (std::size_t i = 0; i < loads.size(); ++i) {
      EXPECT_LT(of_sealed[i], of_bonded[i]);
      EXPECT_LT(of_open[i], of_sealed[i]);
      EXPECT_LT(of_sealed[i], of_slip[i]);
      EXPECT_LE(of_slip[i], of_bonded[i]);
      EXPECT_GT(of_open[i], 0.0);
    }
  }
}

// Nothing but channels and junctions is left.
TEST(DebondedFilms, MayBeAll) {
  RandomTessellationRequest request = {.side = 1e-3, .diameters = {1.0, 1.1, 1.2, 1.3}};
  const Tessellation<3> tessellation(random_sites<3>(request));
  const FilmProblem<3> problem = {.tessellation = tessellation,
                                  .thickness = film_thickness(tessellation, 0.93),
                                  .grain = test::hmx,
                                  .elements = {.divisions = 1}};
  const std::array binders = {Moduli{.bulk = binder_bulk, .shear = 1e7}};
  const auto bonded = film_moduli(problem, binders, loads).front();
  const auto open = film_moduli(debonded(problem, Debonding::open, 1.0), binders, loads).front();
  const auto sealed = film_moduli(debonded(problem, Debonding::sealed, 1.0), binders, loads).front();
  for (std::size_t i = 0; i < loads.size(); ++i) {
    EXPECT_GT(open[i], 0.0);
    EXPECT_LT(open[i], 0.05 * bonded[i]);
    EXPECT_GT(sealed[i], open[i]);
    EXPECT_LT(sealed[i], 0.25 * bonded[i]);
  }
}

TEST(DebondedFilms, MeetTheirReducedResponseInSteps) {
  for (const auto kind : {Debonding::sealed, Debonding::slip}) {
    test::expect_steps_of_the_reduced_response(debonded(test::voronoi_problem(), kind, 0.3), loads);
  }
}

TEST(DebondedFilms, RefuseWindowsAndResolvedFilmsThatAreNoGaps) {
  auto problem = debonded(test::voronoi_problem(Boundary::displacement), Debonding::sealed, 0.1);
  problem.layers = 2;
  test::expect_error<InputError>([&] { require_sound(problem); }, "where the boundary is periodic",
                                 "debonded as open gaps alone");
}

}  // namespace
}  // namespace breccia::films

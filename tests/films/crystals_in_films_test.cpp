// Tests of grains that are crystals, between films, in the plane and in space.

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/films/film_moduli.hpp"
#include "breccia/microstructure/random_sites.hpp"

#include "films/grains_and_films.hpp"
#include "microstructure/expect_error.hpp"
#include "microstructure/uniform.hpp"

namespace breccia {
namespace {

using test::hmx;

constexpr std::array shears_in_space = {Load::shear, Load::shear_yz, Load::shear_zx, Load::diagonal_shear,
                                        Load::axial_shear};

/// A cubic crystal of which a shear along the axes is four times as stiff as one at 45 degrees [Pa].
constexpr double c11 = 20e9, c12 = 14e9, c44 = 12e9;

StiffnessTensor<3> cubic() {
  ElasticConstants constants{};
  for (std::size_t i = 1; i <= 3; ++i) {
    constants[place_of_constant(i, i)] = c11;
    constants[place_of_constant(i + 3, i + 3)] = c44;
    for (std::size_t j = i + 1; j <= 3; ++j) constants[place_of_constant(i, j)] = c12;
  }
  return stiffness_tensor(constants);
}

/// Crystals at random orientations.
std::vector<StiffnessTensor<3>> random_crystals(std::size_t count) {
  std::mt19937_64 engine(3);
  std::vector<StiffnessTensor<3>> crystals;
  for (std::size_t g = 0; g < count; ++g) {
    const double phi1 = 6.28 * uniform(engine), phi = std::acos(1.0 - 2.0 * uniform(engine));
    crystals.push_back(rotated(cubic(), crystal_axes(phi1, phi, 6.28 * uniform(engine))));
  }
  return crystals;
}

LaguerreSites<3> random_sites_in_space(int count) {
  RandomTessellationRequest request;
  request.side = 1e-3;
  request.diameters.assign(static_cast<std::size_t>(count), 1.0);
  return random_sites<3>(request);
}

FilmProblem<3> problem_in_space(const LaguerreSites<3>& sites, double fraction, int divisions = 1) {
  const Tessellation<3> tessellation(sites);
  return {.tessellation = tessellation,
          .thickness = film_thickness(tessellation, fraction),
          .grain = hmx,
          .elements = {.divisions = divisions}};
}

TEST(CrystalsInFilms, OfAnIsotropicStiffnessAreGrainsOfItsModuli) {
  auto plane = test::voronoi_problem();
  const auto expected = film_moduli(plane, std::array{Moduli{3e9, 1e8}}, test::all_loads).front();
  plane.crystals.assign(25, isotropic_stiffness<3>(hmx));
  const auto found = film_moduli(plane, std::array{Moduli{3e9, 1e8}}, test::all_loads).front();
  for (std::size_t load = 0; load < expected.size(); ++load) EXPECT_NEAR(found[load] / expected[load], 1.0, 1e-12);

  auto space = problem_in_space(random_sites_in_space(4), 0.93);
  const auto in_space = film_moduli(space, std::array{Moduli{3e9, 1e8}}, shears_in_space).front();
  space.crystals.assign(4, isotropic_stiffness<3>(hmx));
  const auto again = film_moduli(space, std::array{Moduli{3e9, 1e8}}, shears_in_space).front();
  for (std::size_t load = 0; load < in_space.size(); ++load) EXPECT_NEAR(again[load] / in_space[load], 1.0, 1e-12);
}

// A quarter turn of the plane takes the shear xy to itself, and so it does xx-yy. The triangles within a grain do not
// turn with it.
TEST(CrystalsInFilms, InThePlaneMayBeTurnedWithTheBox) {
  auto sites = test::voronoi_sites_25();
  FilmProblem<2> problem = test::voronoi_problem();
  problem.crystals = random_crystals(25);
  const Moduli binder = {3e9, 1e7};
  const auto before = film_moduli(problem, std::array{binder}, test::all_loads).front();
  for (auto& site : sites.sites) {
    auto& [x, y] = site.position;
    site.position = {sites.side - y, x};
  }
  auto turned = problem;
  turned.tessellation = Tessellation<2>(sites);
  const auto quarter = crystal_axes(0.5 * M_PI, 0.0, 0.0);
  for (auto& crystal : turned.crystals) crystal = rotated(crystal, quarter);
  const auto after = film_moduli(turned, std::array{binder}, test::all_loads).front();
  for (std::size_t load = 0; load < before.size(); ++load) EXPECT_NEAR(after[load] / before[load], 1.0, 3e-4);
}

// A turn about the diagonal of the cube takes x to y, y to z and z to x, and so the shear xy to yz.
TEST(CrystalsInFilms, InSpaceMayBeTurnedWithTheBox) {
  auto sites = random_sites_in_space(6);
  auto problem = problem_in_space(sites, 0.93);
  problem.crystals = random_crystals(6);
  const Moduli binder = {3e9, 1e7};
  const auto before = film_moduli(problem, std::array{binder}, std::array{Load::shear, Load::shear_yz}).front();
  for (auto& site : sites.sites) {
    const auto [x, y, z] = site.position;
    site.position = {z, x, y};
  }
  auto turned = problem_in_space(sites, 0.93);
  Eigen::Matrix3d turn;
  turn << 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  for (const auto& crystal : problem.crystals) turned.crystals.push_back(rotated(crystal, turn));
  const auto after = film_moduli(turned, std::array{binder}, std::array{Load::shear_yz, Load::shear_zx}).front();
  EXPECT_NEAR(after[0] / before[0], 1.0, 1e-7);
  EXPECT_NEAR(after[1] / before[1], 1.0, 1e-7);
}

// Hershey (1954): the shear modulus of an aggregate of cubic crystals by the self-consistent method.
TEST(CrystalsInFilms, WithHardlyABinderAreAPolycrystal) {
  constexpr int count = 27;
  auto problem = problem_in_space(random_sites_in_space(count), 0.995);
  problem.crystals = random_crystals(count);
  const double bulk = (c11 + 2.0 * c12) / 3.0, voigt = (c11 - c12 + 3.0 * c44) / 5.0;
  const double reuss = 5.0 / (4.0 / (c11 - c12) + 3.0 / c44);
  const auto hershey = [&](double g) {
    return ((8.0 * g + 5.0 * c11 + 4.0 * c12) * g - c44 * (7.0 * c11 - 4.0 * c12)) * g -
           c44 * (c11 - c12) * (c11 + 2.0 * c12);
  };
  double low = reuss, high = voigt;
  while (high - low > 1e-9 * voigt) {
    const double middle = 0.5 * (low + high);
    (hershey(middle) < 0.0 ? low : high) = middle;
  }
  const auto moduli = film_moduli(problem, std::array{Moduli{bulk, low}}, shears_in_space).front();
  double mean = 0.0;
  for (const double modulus : moduli) mean += modulus / static_cast<double>(moduli.size());
  EXPECT_GT(mean, reuss);
  EXPECT_LT(mean, voigt);
  EXPECT_NEAR(mean / low, 1.0, 0.03);
  EXPECT_NEAR(film_moduli(problem, std::array{Moduli{bulk, low}}, std::array{Load::bulk}).front()[0] / bulk, 1.0, 0.01);
}

/// The moduli of thin films over those of films that are resolved by two layers.
std::vector<double> thin_over_resolved(FilmProblem<3> problem) {
  const std::array binder = {Moduli{3.6e9, 1e8}};
  auto ratios = film_moduli(problem, binder, shears_in_space).front();
  problem.layers = 2;
  const auto resolved = film_moduli(problem, binder, shears_in_space).front();
  for (std::size_t load = 0; load < ratios.size(); ++load) ratios[load] /= resolved[load];
  return ratios;
}

// Two layers are 3 % from the limit, for crystals as for isotropic grains.
TEST(CrystalsInFilms, AreAsFarFromResolvedFilmsAsIsotropicGrains) {
  auto problem = problem_in_space(random_sites_in_space(4), 0.93, 2);
  const auto isotropic = thin_over_resolved(problem);
  problem.crystals = random_crystals(4);
  const auto crystals = thin_over_resolved(problem);
  for (std::size_t load = 0; load < crystals.size(); ++load) EXPECT_NEAR(crystals[load] / isotropic[load], 1.0, 5e-3);
}

TEST(CrystalsInFilms, AreOneForEachGrain) {
  auto problem = test::voronoi_problem();
  problem.crystals = random_crystals(24);
  test::expect_error<InputError>([&] { require_sound(problem); }, "expected a crystal for each of 25 grains, got 24");
}

}  // namespace
}  // namespace breccia

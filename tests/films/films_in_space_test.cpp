#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/films/film_moduli.hpp"
#include "breccia/microstructure/random_sites.hpp"

#include "films/film_composite.hpp"
#include "films/grains_and_films.hpp"
#include "films/space/space_mesh.hpp"
#include "films/stepped_response.hpp"
#include "microstructure/expect_error.hpp"

namespace breccia::films {
namespace {

using test::binder_bulk;
using test::hmx;

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

/// Random grains with diameters in arithmetic progression, up to a ratio of the largest to the smallest.
FilmProblem<3> random_grains(int count, double ratio, int divisions) {
  RandomTessellationRequest request;
  request.side = 1e-3;
  for (int i = 0; i < count; ++i) request.diameters.push_back(1.0 + (ratio - 1.0) * i / (count - 1));
  const Tessellation<3> tessellation(random_sites<3>(request));
  return {.tessellation = tessellation,
          .thickness = film_thickness(tessellation, 0.93),
          .grain = hmx,
          .elements = {.divisions = divisions}};
}

/// Expects that a binder of the material of the grains makes a box of that material.
void expect_one_material(const FilmProblem<3>& problem) {
  EXPECT_NEAR(FilmOperator<3>(problem).content(), 1.0, 1e-12);
  const std::array loads = {Load::shear, Load::axial_shear, Load::bulk};
  const auto moduli = film_moduli(problem, std::array{hmx}, loads).front();
  EXPECT_NEAR(moduli[0] / hmx.shear, 1.0, 1e-9);
  EXPECT_NEAR(moduli[1] / hmx.shear, 1.0, 1e-9);
  EXPECT_NEAR(moduli[2] / hmx.bulk, 1.0, 1e-9);
}

TEST(FilmsInSpace, PassThePatchTest) {
  for (const auto& problem : {rhombic_dodecahedra(0.93, 1), random_grains(8, 1.0, 2), random_grains(12, 3.0, 1)}) {
    expect_one_material(problem);
  }
}

TEST(FilmsInSpace, PassThePatchTestWithLayers) {
  auto one_layer = random_grains(4, 1.0, 1), three_layers = rhombic_dodecahedra(0.93, 1);
  one_layer.layers = 1;
  three_layers.layers = 3;
  expect_one_material(one_layer);
  expect_one_material(three_layers);
}

// The cells fill a box without boundary, whose Euler characteristic is zero.
TEST(FilmsInSpace, HaveFacesEdgesAndPointsOfAPeriodicBox) {
  const auto complex = cell_complex(random_grains(27, 2.0, 1).tessellation);
  EXPECT_EQ(complex.points.size() + complex.faces.size(), complex.edges.size() + 27);
  EXPECT_EQ(complex.edges.size(), 2 * complex.points.size()) << "four edges meet in a point";
  const auto dodecahedra = cell_complex(rhombic_dodecahedra(0.93, 1).tessellation);
  EXPECT_EQ(dodecahedra.faces.size(), 24U);
  EXPECT_EQ(dodecahedra.edges.size(), 32U);
}

/// Cubes, of which eight meet at each corner.
FilmProblem<3> cubes(int along_edge) {
  LaguerreSites<3> sites;
  sites.side = 1.0;
  for (int i = 0; i < along_edge * along_edge * along_edge; ++i) {
    const auto place = [&](int index) { return (index % along_edge + 0.5) / along_edge; };
    sites.sites.push_back({{place(i), place(i / along_edge), place(i / along_edge / along_edge)}});
  }
  const Tessellation<3> tessellation(sites);
  return {.tessellation = tessellation,
          .thickness = film_thickness(tessellation, 0.9),
          .grain = hmx,
          .elements = {.divisions = 1}};
}

TEST(FilmsInSpace, OfCubesDoNotDependOnTheirNumber) {
  const std::array binders = {hmx, Moduli{.bulk = binder_bulk, .shear = 1e7}};
  const std::array loads = {Load::shear, Load::diagonal_shear, Load::bulk};
  const auto of_eight = film_moduli(cubes(2), binders, loads), of_many = film_moduli(cubes(3), binders, loads);
  EXPECT_NEAR(of_eight[0][0] / hmx.shear, 1.0, 1e-9);
  for (std::size_t l = 0; l < loads.size(); ++l) EXPECT_NEAR(of_many[1][l] / of_eight[1][l], 1.0, 1e-4);
}

TEST(FilmsInSpace, HaveNearlyOneThicknessAndLeaveTheFractionToTheGrains) {
  const auto problem = random_grains(27, 2.0, 1);
  const auto complex = cell_complex(problem.tessellation);
  const auto grains = shrunk_grains(problem.tessellation, complex, 0.93);
  const auto volumes = cell_volumes(problem.tessellation);
  double filled = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i) filled += std::pow(grains[i].scale, 3) * volumes[i] / 1e-9;
  EXPECT_NEAR(filled, 0.93, 1e-12);
  const SpaceMesh mesh(problem);
  double area = 0.0, mean = 0.0, square = 0.0;
  for (std::size_t t = 0; t < mesh.sheets().triangles.size(); ++t) {
    const auto [first, second] = mesh.film(t).triangles;
    const Eigen::Vector3d twice = (first[1] - first[0]).cross(first[2] - first[0]);
    const double thickness = (second[0] - first[0]).dot(twice.normalized());
    area += twice.norm();
    mean += twice.norm() * thickness;
    square += twice.norm() * thickness * thickness;
  }
  mean /= area;
  EXPECT_NEAR(mean * problem.tessellation.side() / problem.thickness, 1.0, 0.02);
  EXPECT_LT(std::sqrt(square / area / (mean * mean) - 1.0), 0.15);
}

// G_xy and G_xx-yy of rhombic dodecahedra at 93 %: another program with the same elements, and grains and binder
// resolved by Taylor-Hood tetrahedra, six elements an edge and two layers across the films.
TEST(FilmsInSpace, OfRhombicDodecahedraAreThoseOfOtherPrograms) {
  struct Row {
    double shear;                              ///< [Pa]
    std::array<double, 2> one, two, resolved;  ///< [MPa]; with one and two elements an edge, and resolved
  };
  constexpr std::array rows = {
      Row{1e9, {5028, 4870}, {5048, 4881}, {5051, 4878}}, Row{1e8, {3869, 3020}, {3984, 3080}, {4001, 3082}},
      Row{1e7, {3191, 1959}, {3250, 1966}, {3237, 1949}}, Row{1e6, {1907, 761}, {1913, 792}, {1890, 791}},
      Row{1e5, {393, 110}, {400, 120}, {391, 122}}};
  std::vector<Moduli> binders;
  binders.reserve(rows.size());
  for (const auto& row : rows) binders.push_back({.bulk = binder_bulk, .shear = row.shear});
  const std::array loads = {Load::shear, Load::diagonal_shear};
  const auto of_one = film_moduli(rhombic_dodecahedra(0.93, 1), binders, loads);
  const auto of_two = film_moduli(rhombic_dodecahedra(0.93, 2), binders, loads);
  const auto of_three = film_moduli(rhombic_dodecahedra(0.93, 3), binders, loads);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t load = 0; load < loads.size(); ++load) {
      SCOPED_TRACE(std::to_string(rows[i].shear) + " Pa, load " + std::to_string(load));
      EXPECT_NEAR(of_one[i][load] / (1e6 * rows[i].one[load]), 1.0, 5e-3);
      EXPECT_NEAR(of_two[i][load] / (1e6 * rows[i].two[load]), 1.0, 5e-3);
      EXPECT_NEAR(of_two[i][load] / (1e6 * rows[i].resolved[load]), 1.0, rows[i].shear > 1e5 ? 0.015 : 0.025);
      EXPECT_NEAR(of_three[i][load] / (1e6 * rows[i].resolved[load]), 1.0, rows[i].shear > 1e5 ? 0.01 : 0.025);
    }
  }
}

// Rigid grains with thin films of an incompressible binder: G/g = A (w/t)^3 + B (w/t) + 4/3, w the cube root of the
// volume of a cell, by Reynolds' equation on the faces.
TEST(FilmsInSpace, SqueezeTheirBinderLikeThinFilmsBetweenRigidGrains) {
  constexpr double share = 1e-3;  // t/w
  auto problem = rhombic_dodecahedra(0.93, 3);
  problem.thickness = share * std::cbrt(0.25);
  problem.grain = {.bulk = 1e11, .shear = 1e11};
  constexpr double shear = 1.0;
  const auto moduli = film_moduli(problem, std::array{Moduli{.bulk = 1e9 * shear, .shear = shear}},
                                  std::array{Load::diagonal_shear, Load::shear})
                          .front();
  EXPECT_NEAR(moduli[0] / (0.0252 / std::pow(share, 3) + 0.421 / share), 1.0, 0.01);
  EXPECT_NEAR(moduli[1] / (0.0884 / std::pow(share, 3) + 0.281 / share), 1.0, 0.01);
}

TEST(FilmsInSpace, MeetTheirReducedResponseInSteps) {
  constexpr std::array loads = {Load::shear, Load::bulk};
  test::expect_steps_of_the_reduced_response(random_grains(4, 1.5, 1), loads);
}

// Two cells that touch each other's images across the same side have planes in common for any weights, and a cell that
// touches images of itself on several sides has them for any positions, too.
TEST(FilmsInSpace, RefuseGrainsThatTouchImagesOfThemselvesOnSeveralSides) {
  LaguerreSites<3> sites;
  sites.side = 1.0;
  sites.sites = {{{0.2, 0.5, 0.5}}, {{0.7, 0.5, 0.5}}, {{0.2, 0.1, 0.9}}, {{0.8, 0.05, 0.2}}};
  FilmProblem<3> problem = {
      .tessellation = Tessellation<3>(sites), .thickness = 0.01, .grain = hmx, .elements = {.divisions = 1}};
  EXPECT_NEAR(film_moduli(problem, std::array{hmx}, std::array{Load::shear})[0][0] / hmx.shear, 1.0, 1e-6);
  sites.sites.resize(2);
  problem.tessellation = Tessellation<3>(sites);
  test::expect_error<InputError>([&] { static_cast<void>(SpaceMesh(problem)); }, "touches images of itself",
                                 "a box of more grains");
}

TEST(FilmsInSpace, RefuseFilmsThatLeaveNothingOfAGrain) {
  auto problem = random_grains(12, 20.0, 1);
  const auto complex = cell_complex(problem.tessellation);
  test::expect_error<InputError>([&] { static_cast<void>(shrunk_grains(problem.tessellation, complex, 1e-3)); },
                                 "at a fraction of 0.001 the grains of the sites", "a higher fraction");
}

TEST(FilmsInSpace, RefuseWhatTheyAreNot) {
  auto problem = rhombic_dodecahedra(0.93, 0);
  problem.boundary = Boundary::traction;
  test::expect_error<InputError>([&] { require_sound(problem); }, "elements along an edge", "periodic");
  LaguerreSites<3> one;
  one.side = 1.0;
  one.sites = {{{0.5, 0.5, 0.5}}};
  one.film_shares = {1.0};
  const FilmProblem<3> of_one = {.tessellation = Tessellation<3>(one), .thickness = 0.1, .grain = hmx};
  test::expect_error<InputError>([&] { require_sound(of_one); }, "two grains at least", "without shares");
}

}  // namespace
}  // namespace breccia::films

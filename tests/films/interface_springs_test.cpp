#include "films/assembly/interface_springs.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/films/film_moduli.hpp"
#include "breccia/microstructure/cell_faces.hpp"
#include "breccia/microstructure/random_sites.hpp"

#include "films/grains_and_films.hpp"
#include "films/space/film_wedge.hpp"
#include "films/space/space_mesh.hpp"
#include "films/stepped_response.hpp"
#include "microstructure/expect_error.hpp"

namespace breccia::films {
namespace {

using test::all_loads;

/// A problem with a share of its films debonded in this way.
template <int dim>
FilmProblem<dim> with(FilmProblem<dim> problem, Debonding kind, double share = 1.0) {
  problem.debonded = {.kind = kind, .faces = random_faces(problem.tessellation, share, 1).faces};
  return problem;
}

/// A problem with a share of its films on springs of this stiffness [Pa/m].
template <int dim>
FilmProblem<dim> on_springs(FilmProblem<dim> problem, const InterfaceStiffness& springs, double share = 1.0) {
  problem = with(std::move(problem), Debonding::spring, share);
  problem.debonded.springs = springs;
  return problem;
}

template <int dim>
std::vector<double> moduli_of(const FilmProblem<dim>& problem, const Moduli& binder) {
  return film_moduli(problem, std::array{binder}, all_loads).front();
}

/// Four grains in space whose films are a thousandth of their distance thick.
FilmProblem<3> thin_films_in_space(const Moduli& grain) {
  const LaguerreSites<3> sites = {
      .side = 1.0, .sites = {{{0.25, 0.25, 0.25}}, {{0.75, 0.75, 0.25}}, {{0.75, 0.25, 0.75}}, {{0.25, 0.75, 0.75}}}};
  return {.tessellation = Tessellation<3>(sites),
          .thickness = 1e-3 * std::cbrt(0.25),
          .grain = grain,
          .elements = {.divisions = 2}};
}

FilmProblem<3> random_grains_in_space() {
  const RandomTessellationRequest request = {.side = 1e-3, .diameters = {1.0, 1.1, 1.2, 1.3}};
  const Tessellation<3> tessellation(random_sites<3>(request));
  return {.tessellation = tessellation,
          .thickness = film_thickness(tessellation, 0.93),
          .grain = test::hmx,
          .elements = {.divisions = 1}};
}

TEST(InterfaceSprings, ResistToAUniformJumpWithTheirStiffness) {
  const Eigen::Vector3d normal = Eigen::Vector3d(1.0, -2.0, 2.0) / 3.0, along = Eigen::Vector3d(2.0, 2.0, 1.0) / 3.0;
  constexpr double area = 0.7;
  const Eigen::Matrix2d products = area * Eigen::Matrix2d{{2.0, 1.0}, {1.0, 2.0}} / 6.0;
  const auto stiffness = spring_stiffness({.normal = 5.0, .tangential = 3.0}, normal, products);
  Eigen::VectorXd across(6), tangential(6);
  across << normal, normal;
  tangential << along, along;
  EXPECT_NEAR(across.dot(stiffness * across), 5.0 * area, 1e-14);
  EXPECT_NEAR(tangential.dot(stiffness * tangential), 3.0 * area, 1e-14);
  EXPECT_NEAR(across.dot(stiffness * tangential), 0.0, 1e-14);
}

// The springs of a face, for a jump that is the same everywhere: their stiffness times the area, in sides of the box.
TEST(InterfaceSprings, InSpaceHaveTheAreaOfTheirSide) {
  const auto problem = on_springs(random_grains_in_space(), {.normal = 5e12, .tangential = 2e12}, 0.3);
  const SpaceMesh mesh(problem);
  const Eigen::Vector3d jump(0.3, -0.5, 0.8);
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.sheets().triangles.size(); ++t) {
    const auto springs = mesh.springs(t);
    if (springs.jumps.empty()) continue;
    ++count;
    const auto wedge = mesh.film(t);
    const auto& corners = wedge.triangles[1];
    const Eigen::Vector3d area = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double across = jump.dot(area.normalized());
    const double per_area = 5e9 * across * across + 2e9 * (jump.squaredNorm() - across * across);
    const Eigen::VectorXd uniform = jump.replicate(6, 1);
    EXPECT_NEAR(uniform.dot(springs.stiffness * uniform) / (per_area * area.norm()), 1.0, 1e-12);
  }
  EXPECT_GT(count, 0U);
}

// What a uniform motion of the second side adds to the volume of a skew wedge leaves through its three ends, or is
// swept by that side.
TEST(InterfaceSprings, InSpaceLoseAtTheirEndsWhatTheSideDoesNotSweep) {
  Wedge wedge;
  wedge.triangles[0] = {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(1.0, 0.1, 0.0), Eigen::Vector3d(0.2, 0.9, 0.0)};
  wedge.triangles[1] = {Eigen::Vector3d(0.05, -0.1, 0.1), Eigen::Vector3d(1.2, 0.15, 0.12),
                        Eigen::Vector3d(0.1, 1.1, 0.09)};
  const Eigen::Vector3d motion(0.4, -0.7, 0.5);
  const Eigen::VectorXd uniform = motion.replicate(6, 1);
  const double grown = (film_wedge(wedge, false).dilatation.middleCols<18>(18) * uniform).sum();
  double left = 0.0;
  for (std::size_t turn = 0; turn < 3; ++turn) {
    Wedge turned;
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t k = 0; k < 3; ++k) turned.triangles[side][k] = wedge.triangles[side][(k + turn) % 3];
    }
    left += (outflow_of_second_side(turned) * uniform).sum();
  }
  const auto& corners = wedge.triangles[1];
  const double swept = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(motion);
  EXPECT_NEAR(grown, left + swept, 1e-13);
}

// Two slabs with two interfaces a period. The binder is soft, so that the corners between four grains bridge little,
// and so thin that its films are stiffer than the springs by far.
TEST(FilmsOnSprings, AreInSeriesWithTheGrainsBetweenSlabs) {
  const LaguerreSites<2> sites = {.side = 2.0, .sites = {{{0.5, 1.0}}, {{1.5, 1.0}}}};
  constexpr Moduli material = {.bulk = 3e9, .shear = 1e9};
  constexpr InterfaceStiffness springs = {.normal = 2e9, .tangential = 0.7e9};
  FilmProblem<2> problem = {.tessellation = Tessellation<2>(sites), .thickness = 1e-8, .grain = material};
  problem.debonded = {.kind = Debonding::spring,
                      .faces = faces_of_pairs(problem.tessellation, std::array{SitePair{{0, 1}, {}}}).faces,
                      .springs = springs};
  ASSERT_EQ(problem.debonded.faces.size(), 2U);
  const auto moduli = moduli_of(problem, {.bulk = 3e5, .shear = 1e5});
  const double along = 2.0 / (2.0 * springs.tangential), across = 2.0 / (2.0 * springs.normal);
  EXPECT_NEAR(moduli[0] * (1.0 / material.shear + along), 1.0, 1e-3);
  // The strains xx and yy of the grains are e and -1: their stress xx is in series with the springs.
  constexpr double lame = material.bulk - 2.0 / 3.0 * material.shear, stiff = lame + 2.0 * material.shear;
  const double e = (1.0 + across * lame) / (1.0 + across * stiff);
  const double xx = stiff * e - lame, yy = lame * e - stiff;
  EXPECT_NEAR(moduli[1] / ((xx - yy) / 4.0), 1.0, 1e-3);
}

TEST(FilmsOnSprings, AreBondedByStiffOnes) {
  constexpr double stiff = 1e22;  // films have some 1e15 [Pa/m]
  for (const double shear : {1e9, 1e5}) {
    const Moduli binder = {.bulk = test::binder_bulk, .shear = shear};
    const auto expect_bonded = [&binder](const auto& problem) {
      const auto bonded = moduli_of(problem, binder), moduli = moduli_of(on_springs(problem, {stiff, stiff}), binder);
      for (std::size_t i = 0; i < all_loads.size(); ++i) EXPECT_NEAR(moduli[i] / bonded[i], 1.0, 1e-5);
    };
    expect_bonded(test::voronoi_problem());
    expect_bonded(random_grains_in_space());
  }
}

// Films that slide resist to being squeezed with a quarter of the force (Eq. 61a). Of the flow along them a quarter is
// that of the parabola, to which alone the bends resist, so that the bends have an eighth of their share.
TEST(FilmsOnSprings, SlideWhereTheyAreHeldAcrossAlone) {
  constexpr Moduli binder = {.bulk = 1e9, .shear = 1.0}, rigid = {.bulk = 1e11, .shear = 1e11};
  constexpr InterfaceStiffness across = {.normal = 1e15, .tangential = 1e-1};
  const auto problem = thin_films_in_space(rigid);
  const auto bonded = moduli_of(problem, binder), held = moduli_of(on_springs(problem, across), binder);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(held[i] / bonded[i], 0.25, 2.5e-3);
  auto plane = test::voronoi_problem();
  plane.grain = rigid;
  plane.thickness *= 0.05;
  const auto sliding = moduli_of(with(plane, Debonding::slip), binder),
             free = moduli_of(on_springs(plane, across), binder);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(free[i] / sliding[i], 1.0, 0.03);
}

// The binder of a film that is free on one side takes what flows into it, as an open gap does, with little resistance;
// sealed gaps are up to three times as stiff here.
TEST(FilmsOnSprings, AreCloseToOpenGapsWhereTheyAreSoft) {
  constexpr double soft = 1e3;
  for (const double shear : {1e9, 1e5}) {
    const Moduli binder = {.bulk = test::binder_bulk, .shear = shear};
    const auto problem = test::voronoi_problem();
    const auto open = moduli_of(with(problem, Debonding::open, 0.3), binder);
    const auto moduli = moduli_of(on_springs(problem, {soft, soft}, 0.3), binder);
    for (std::size_t i = 0; i < all_loads.size(); ++i) {
      EXPECT_GT(moduli[i], open[i]);
      EXPECT_NEAR(moduli[i] / open[i], 1.0, 0.1);
    }
  }
}

TEST(FilmsOnSprings, MeetTheirReducedResponseInSteps) {
  test::expect_steps_of_the_reduced_response(on_springs(test::voronoi_problem(), {3e13, 1e13}, 0.5), all_loads);
}

TEST(FilmsOnSprings, NeedAStiffness) {
  test::expect_error<InputError>(
      [] {
        require_sound(on_springs(test::voronoi_problem(), {0.0, -1.0}));
      },
      "the normal stiffness of the springs must be positive and finite, got 0 Pa/m",
      "the tangential stiffness of the springs must be positive and finite, got -1 Pa/m");
}

}  // namespace
}  // namespace breccia::films

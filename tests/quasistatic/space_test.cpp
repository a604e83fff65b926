// Tests of the quasi-static method in three dimensions: exact composites, two dimensions as a special case, and the
// solvers against each other.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/quasistatic/apparent_moduli.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "discretisation/labels.hpp"
#include "discretisation/mixed_cells.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "quasistatic/stepping/log_time_stepping.hpp"

namespace breccia {
namespace {

constexpr std::array all_loads = {Load::shear,          Load::shear_yz,          Load::shear_zx,
                                  Load::diagonal_shear, Load::diagonal_shear_yz, Load::bulk};
const Material soft = {"soft", 1.0, PronySeries(3.0), PronySeries(1.0)};
const Material hard = {"hard", 1.0, PronySeries(40.0), PronySeries(30.0)};

/// Two spheres, of which none lies in a symmetric position, in a box of side 1, with mixed cells.
QuasistaticProblem<3> two_spheres(int cells, Boundary boundary, const std::array<std::size_t, 3>& axes = {0, 1, 2}) {
  Microstructure<3> box = {1.0, Walls::hard, {}};
  constexpr std::array<Vector<3>, 2> centres = {{{0.31, 0.36, 0.42}, {0.72, 0.66, 0.61}}};
  constexpr std::array diameters = {0.5, 0.4};
  for (std::size_t i = 0; i < centres.size(); ++i) {
    box.particles.push_back({{centres[i][axes[0]], centres[i][axes[1]], centres[i][axes[2]]}, diameters[i]});
  }
  constexpr std::array<PhaseIndex, 2> spheres = {1, 1};
  return {
      .discretisation = discretise_mixed(box, cells, 0, spheres, 2), .materials = {soft, hard}, .boundary = boundary};
}

/// Points of material 1 where a coordinate is between two values along an axis, with one point in each half of a cell.
Discretisation<3> layers(const Grid<3>& grid, std::size_t axis, double begin, double end) {
  return discretise<3>(grid, [=](const Vector<3>& position) -> PhaseAt {
    const bool is_between = position[axis] >= begin && position[axis] < end;
    return {static_cast<PhaseIndex>(is_between ? 1 : 0),
            std::min(std::abs(position[axis] - begin), std::abs(position[axis] - end))};
  });
}

TEST(Space, LaminatesAreExact) {
  constexpr std::array<std::array<Load, 2>, 3> across_shears = {
      {{Load::shear, Load::shear_zx}, {Load::shear, Load::shear_yz}, {Load::shear_yz, Load::shear_zx}}};
  constexpr std::array along_shears = {Load::shear_yz, Load::shear_zx, Load::shear};
  const double mean = 0.5 * (1.0 + 30.0), harmonic = 1.0 / (0.5 * (1.0 / 1.0 + 1.0 / 30.0));
  // Equal strains of 1/3 in the layers; across them the stress is the same in both.
  const auto longitudinal = [](double bulk, double shear) { return bulk + 4.0 / 3.0 * shear; };
  const auto lateral = [](double bulk, double shear) { return bulk - 2.0 / 3.0 * shear; };
  const double m1 = longitudinal(3.0, 1.0), m2 = longitudinal(40.0, 30.0), l1 = lateral(3.0, 1.0),
               l2 = lateral(40.0, 30.0);
  const double across = (1.0 / 3.0 + 0.5 * (l1 / m1 + l2 / m2) * 2.0 / 3.0) / (0.5 * (1.0 / m1 + 1.0 / m2));
  const auto in_layer = [&](double m, double l) { return (m + l) / 3.0 + l * (across - l * 2.0 / 3.0) / m; };
  const double bulk = (across + 2.0 * 0.5 * (in_layer(m1, l1) + in_layer(m2, l2))) / 3.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const QuasistaticProblem<3> problem = {.discretisation = layers(Grid<3>{{4, 4, 4}, 0.25}, axis, 0.25, 0.75),
                                           .materials = {soft, hard},
                                           .boundary = Boundary::periodic};
    const std::array loads = {along_shears[axis], across_shears[axis][0], across_shears[axis][1], Load::bulk};
    const auto moduli = apparent_moduli(problem, loads);
    EXPECT_NEAR(moduli[0] / mean, 1.0, 1e-10) << axis;
    EXPECT_NEAR(moduli[1] / harmonic, 1.0, 1e-10) << axis;
    EXPECT_NEAR(moduli[2] / harmonic, 1.0, 1e-10) << axis;
    EXPECT_NEAR(moduli[3] / bulk, 1.0, 1e-10) << axis;
  }
}

/// Moduli of a cylinder along z under the loads of the plane in three dimensions over those in two (plane strain), with
/// n x n cells.
std::array<double, 2> space_over_plane(int n, Volumetric volumetric) {
  const auto at = [](double x, double y) -> PhaseAt {
    const bool is_inside = std::abs(x - 0.5) < 0.25 && std::abs(y - 0.625) < 0.125;
    return {static_cast<PhaseIndex>(is_inside ? 1 : 0), 0.0};
  };
  QuasistaticProblem<3> space = {
      .discretisation = discretise<3>(Grid<3>{{n, n, 2}, 1.0 / n},
                                      [&](const Vector<3>& position) { return at(position[0], position[1]); }),
      .materials = {soft, hard},
      .volumetric = volumetric,
      .boundary = Boundary::periodic};
  QuasistaticProblem<2> plane = {
      .discretisation = discretise<2>(Grid<2>{{n, n}, 1.0 / n},
                                      [&](const Vector<2>& position) { return at(position[0], position[1]); }),
      .materials = {soft, hard},
      .volumetric = volumetric,
      .boundary = Boundary::periodic};
  space.linear.method = LinearMethod::direct;
  space.linear.tolerance = plane.linear.tolerance = 1e-14;
  constexpr std::array loads = {Load::shear, Load::diagonal_shear};
  const auto found = apparent_moduli(space, loads), expected = apparent_moduli(plane, loads);
  return {found[0] / expected[0], found[1] / expected[1]};
}

TEST(Space, OfACylinderHasTheModuliOfTwoDimensions) {
  for (const double ratio : space_over_plane(8, Volumetric::standard)) EXPECT_NEAR(ratio, 1.0, 1e-10);
  // Averaged volumetric strains are spread over as many axes as there are dimensions (theory, section 18): the moduli
  // differ by an error of the grid.
  const auto coarse = space_over_plane(8, Volumetric::averaged), fine = space_over_plane(16, Volumetric::averaged);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_LT(std::abs(coarse[i] - 1.0), 5e-3);
    EXPECT_LT(std::abs(fine[i] - 1.0), 0.6 * std::abs(coarse[i] - 1.0));
  }
}

TEST(Space, TheIterativeSolverFindsWhatTheDirectOneFinds) {
  for (const auto boundary : test::boundaries) {
    auto problem = two_spheres(7, boundary);
    problem.linear.method = LinearMethod::direct;
    const auto expected = apparent_moduli(problem, all_loads);
    problem.linear.method = LinearMethod::iterative;
    const auto found = apparent_moduli(problem, all_loads);
    for (std::size_t i = 0; i < all_loads.size(); ++i) {
      // The square of the tolerance of the energy is far below this tolerance.
      EXPECT_NEAR(found[i] / expected[i], 1.0, 1e-9) << name_of(boundary) << ", " << name_of(all_loads[i]);
    }
  }
}

TEST(Space, AnyNumberOfThreadsHasTheSameBits) {
  for (const auto boundary : test::boundaries) {
    auto problem = two_spheres(9, boundary);
    problem.linear.method = LinearMethod::iterative;
    problem.linear.threads = 1;
    const auto expected = apparent_moduli(problem, all_loads);
    for (const int threads : {2, 3}) {
      problem.linear.threads = threads;
      EXPECT_EQ(apparent_moduli(problem, all_loads), expected) << name_of(boundary) << ", " << threads;
    }
  }
}

// The axes of the box are changed cyclically: y becomes x.
TEST(Space, ACyclicChangeOfAxesChangesTheLoadsAlike) {
  for (const auto boundary : test::boundaries) {
    const auto found = apparent_moduli(two_spheres(6, boundary), all_loads);
    const auto changed = apparent_moduli(two_spheres(6, boundary, {1, 2, 0}), all_loads);
    constexpr double rounding = 1e-10;
    EXPECT_NEAR(changed[0] / found[1], 1.0, rounding) << "xy is yz";
    EXPECT_NEAR(changed[1] / found[2], 1.0, rounding) << "yz is zx";
    EXPECT_NEAR(changed[2] / found[0], 1.0, rounding) << "zx is xy";
    EXPECT_NEAR(changed[3] / found[4], 1.0, rounding) << "xx - yy is yy - zz";
    EXPECT_NEAR(changed[5] / found[5], 1.0, rounding) << "equal strains stay";
  }
}

TEST(Space, TheBoundariesAreOrdered) {
  const auto upper = apparent_moduli(two_spheres(8, Boundary::displacement), all_loads);
  const auto between = apparent_moduli(two_spheres(8, Boundary::periodic), all_loads);
  const auto lower = apparent_moduli(two_spheres(8, Boundary::traction), all_loads);
  for (std::size_t i = 0; i < all_loads.size(); ++i) {
    EXPECT_GT(upper[i], between[i]) << name_of(all_loads[i]);
    EXPECT_GT(between[i], lower[i]) << name_of(all_loads[i]);
    EXPECT_GT(lower[i], all_loads[i] == Load::bulk ? 3.0 : 1.0) << name_of(all_loads[i]);
  }
}

// Both moduli of the matrix relax.
TEST(Space, TheReducedResponseIsThatOfSteps) {
  const Material relaxing = {"matrix", 1.0, PronySeries(2.0, {{1e-3, 4.0}}),
                             PronySeries(0.1, {{1e-4, 2.0}, {1e-2, 0.5}})};
  constexpr std::array loads = {Load::shear_zx, Load::bulk};
  const auto times = test::logarithmic(1e-8, 1.0, 40);
  for (const auto boundary : test::boundaries) {
    auto problem = two_spheres(5, boundary);
    problem.materials[0] = relaxing;
    const auto stepped = run_log_time_stepping(problem, loads, times);
    const auto sampled = sample_responses(problem, loads, matrix_path(0, carson_path(relaxing, {1e-6, 1.0})));
    for (std::size_t load = 0; load < loads.size(); ++load) {
      const auto compliance = creep_compliance(sampled.responses[load], relaxing);
      const auto modulus = relaxation_modulus(compliance);
      for (std::size_t i = 0; i < times.size(); ++i) {
        if (times[i] < 1e-6) continue;
        const double value = boundary == Boundary::traction ? compliance.at(times[i]) : modulus.at(times[i]);
        EXPECT_NEAR(value / stepped.responses[load].values[i], 1.0, 1e-3) << name_of(boundary) << ", " << times[i];
      }
    }
  }
}

}  // namespace
}  // namespace breccia

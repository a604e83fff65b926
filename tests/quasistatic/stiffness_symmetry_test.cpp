// Tests of the symmetries of the whole stiffness tensor of a cube without symmetries of its own. Any composite must
// have them, however coarse its grid is.

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "discretisation/mixed_cells.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/stepping/log_time_stepping.hpp"

namespace breccia {
namespace {

using Mandel = Eigen::Matrix<double, 6, 1>;
using Stiffness = Eigen::Matrix<double, 6, 6>;
constexpr std::array six_loads = {Load::shear,          Load::shear_yz,          Load::shear_zx,
                                  Load::diagonal_shear, Load::diagonal_shear_yz, Load::bulk};

/// One of the 48 rotations and reflections that turn a cube into itself.
struct CubeSymmetry {
  /// The original axes of the cube that are the first, second and third axis after the symmetry.
  std::array<int, 3> axes;
  std::array<bool, 3> is_flipped;  ///< whether an axis of the turned cube is flipped
};

constexpr CubeSymmetry identity = {{0, 1, 2}, {false, false, false}};
/// Three symmetries that generate all others, and a turn by 90 degrees, which is one of those.
constexpr std::array<CubeSymmetry, 4> generators = {{{{1, 2, 0}, {false, false, false}},
                                                     {{1, 0, 2}, {false, false, false}},
                                                     {{0, 1, 2}, {true, false, false}},
                                                     {{1, 0, 2}, {true, false, false}}}};

/// The matrix by which a symmetry turns the Mandel components of a tensor of second order.
Stiffness mandel_rotation(const CubeSymmetry& symmetry) {
  Stiffness rotation = Stiffness::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      const auto at_i = static_cast<std::size_t>(i), at_j = static_cast<std::size_t>(j);
      const bool changes_sign = symmetry.is_flipped[at_i] != symmetry.is_flipped[at_j];
      rotation(component_index<3>(i, j), component_index<3>(symmetry.axes[at_i], symmetry.axes[at_j])) =
          changes_sign ? -1.0 : 1.0;
    }
  }
  return rotation;
}

/// Two spheres of different size and stiffness in no symmetric position of a box of side 1, with mixed cells, in a
/// matrix, after a symmetry of the box.
QuasistaticProblem<3> turned_spheres(const CubeSymmetry& symmetry, Boundary boundary) {
  Microstructure<3> box = {1.0, Walls::hard, {}};
  constexpr std::array<Vector<3>, 2> centres = {{{0.31, 0.36, 0.42}, {0.72, 0.66, 0.61}}};
  constexpr std::array diameters = {0.5, 0.4};
  for (std::size_t i = 0; i < centres.size(); ++i) {
    Vector<3> centre{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double coordinate = centres[i][static_cast<std::size_t>(symmetry.axes[axis])];
      centre[axis] = symmetry.is_flipped[axis] ? 1.0 - coordinate : coordinate;
    }
    box.particles.push_back({centre, diameters[i]});
  }
  constexpr std::array<PhaseIndex, 2> phases = {1, 2};
  constexpr int cells = 6;
  QuasistaticProblem<3> problem = {.discretisation = discretise_mixed(box, cells, 0, phases, 3),
                                   .materials = {{"matrix", 1.0, PronySeries(3.0), PronySeries(1.0)},
                                                 {"hard", 1.0, PronySeries(40.0), PronySeries(30.0)},
                                                 {"harder", 1.0, PronySeries(200.0), PronySeries(90.0)}},
                                   .boundary = boundary};
  problem.linear.method = LinearMethod::direct;
  return problem;
}

/// The mean of tensors in Mandel's notation, in which shears have the factor sqrt(2).
Mandel mandel_mean(const std::vector<std::array<double, 6>>& tensors) {
  Mandel mean = Mandel::Zero();
  for (const auto& tensor : tensors) mean += Mandel(tensor.data());
  mean /= static_cast<double>(tensors.size());
  mean.tail<3>() *= std::sqrt(2.0);
  return mean;
}

/// Means of the strain (first) and of the stress (second) under each of the six loads, by column.
std::array<Stiffness, 2> means_under_loads(const QuasistaticProblem<3>& problem) {
  std::array<Stiffness, 2> means;
  constexpr std::array times = {1.0};
  for (std::size_t load = 0; load < six_loads.size(); ++load) {
    const auto found = run_log_time_stepping(problem, std::array{six_loads[load]}, times, {}, times);
    const auto column = static_cast<Eigen::Index>(load);
    means[0].col(column) = mandel_mean(found.fields.at(0).fields.strain);
    means[1].col(column) = mandel_mean(found.fields.at(0).fields.stress);
  }
  return means;
}

Stiffness stiffness_of(const QuasistaticProblem<3>& problem) {
  const auto [strains, stresses] = means_under_loads(problem);
  return stresses * strains.inverse();
}

double difference(const Stiffness& one, const Stiffness& other) {
  return (one - other).cwiseAbs().maxCoeff() / one.cwiseAbs().maxCoeff();
}

class StiffnessOfACube : public testing::TestWithParam<Boundary> {};

TEST_P(StiffnessOfACube, IsSymmetric) {
  const auto stiffness = stiffness_of(turned_spheres(identity, GetParam()));
  EXPECT_LT(difference(stiffness, stiffness.transpose()), 1e-10);
  // The box has no symmetry: no two entries are the same.
  EXPECT_GT(std::abs(stiffness(0, 0) - stiffness(1, 1)), 1e-3);
  EXPECT_GT(std::abs(stiffness(3, 4)), 1e-3);
}

TEST_P(StiffnessOfACube, TurnsWithItsSpheres) {
  const auto stiffness = stiffness_of(turned_spheres(identity, GetParam()));
  for (const auto& symmetry : generators) {
    const auto rotation = mandel_rotation(symmetry);
    const auto turned = stiffness_of(turned_spheres(symmetry, GetParam()));
    EXPECT_LT(difference(rotation * stiffness * rotation.transpose(), turned), 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(All, StiffnessOfACube, testing::ValuesIn(test::boundaries),
                         [](const auto& chosen) { return std::string(name_of(chosen.param)); });

}  // namespace
}  // namespace breccia

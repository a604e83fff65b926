// Tests of the stiffness of crystals in other axes.

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "breccia/discretisation/crystals.hpp"

namespace breccia {
namespace {

constexpr std::array<std::array<int, 2>, 6> pairs = {{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}}};

int voigt(int i, int j) {
  return i == j ? i : 6 - i - j;
}

StiffnessTensor<3> triclinic() {
  ElasticConstants constants{};
  for (std::size_t i = 0; i < constants.size(); ++i) constants[i] = 0.1 * static_cast<double>(i % 5) - 0.2;
  for (std::size_t i = 1; i <= 6; ++i) constants[place_of_constant(i, i)] = 3.0 + static_cast<double>(i);
  return stiffness_tensor(constants);
}

TEST(CrystalRotation, IsThatOfTheTensorOfFourthOrder) {
  const auto stiffness = triclinic();
  const auto axes = crystal_axes(0.3, 1.1, -2.0);
  const auto found = rotated(stiffness, axes);
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      const auto [i, j] = pairs[static_cast<std::size_t>(row)];
      const auto [k, l] = pairs[static_cast<std::size_t>(column)];
      double expected = 0.0;
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
          for (int c = 0; c < 3; ++c) {
            for (int d = 0; d < 3; ++d) {
              expected += axes(i, a) * axes(j, b) * axes(k, c) * axes(l, d) * stiffness(voigt(a, b), voigt(c, d));
            }
          }
        }
      }
      EXPECT_NEAR(found(row, column), expected, 1e-13);
    }
  }
}

// Half a right angle about z: C'11 = (C11 + C12) / 2 + C44, C'66 = (C11 - C12) / 2.
TEST(CrystalRotation, OfACubicCrystalByHalfARightAngle) {
  ElasticConstants constants{};
  for (std::size_t i = 1; i <= 3; ++i) {
    constants[place_of_constant(i, i)] = 10.0;
    constants[place_of_constant(i + 3, i + 3)] = 1.0;
    for (std::size_t j = i + 1; j <= 3; ++j) constants[place_of_constant(i, j)] = 6.0;
  }
  const auto found = rotated(stiffness_tensor(constants), crystal_axes(0.25 * std::numbers::pi, 0.0, 0.0));
  EXPECT_NEAR(found(0, 0), 9.0, 1e-14);
  EXPECT_NEAR(found(5, 5), 2.0, 1e-14);
  EXPECT_NEAR(found(2, 2), 10.0, 1e-14);
}

TEST(CrystalRotation, HasBungesAxes) {
  // Turned by 90 degrees about z and then about the new x: the z of the crystal is the x of the box.
  const auto axes = crystal_axes(0.5 * std::numbers::pi, 0.5 * std::numbers::pi, 0.0);
  EXPECT_NEAR((axes.col(0) - Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-15);
  EXPECT_NEAR((axes.col(2) - Eigen::Vector3d::UnitX()).norm(), 0.0, 1e-15);
}

TEST(CrystalRotation, InPlaneStrainKeepsTheStrainsOfThePlane) {
  const auto stiffness = triclinic();
  const auto plane = stiffness_in<2>(stiffness);
  EXPECT_EQ(plane(0, 1), stiffness(0, 1));
  EXPECT_EQ(plane(2, 0), stiffness(5, 0));
  EXPECT_EQ(plane(2, 2), stiffness(5, 5));
}

}  // namespace
}  // namespace breccia

#pragma once

#include <array>

#include <Eigen/Core>

namespace breccia::films {

/// Places and weights of Gauss' rule on [-1, 1], exact to the fifth order.
struct GaussRule {
  std::array<double, 3> points, weights;
};
[[nodiscard]] const GaussRule& gauss_rule();

/// Quadratic shape functions of the start, middle and end of a line at a point x from -1 to 1, and their derivatives by
/// x.
[[nodiscard]] Eigen::Vector3d quadratic(double x);
[[nodiscard]] Eigen::Vector3d quadratic_slope(double x);
/// Linear shape functions of the start and end of the line.
[[nodiscard]] Eigen::Vector2d linear(double x);

}  // namespace breccia::films

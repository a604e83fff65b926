#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace breccia::films {

/// A wedge between two triangles: of the film between two faces, or of the channel between three edges. The point with
/// the barycentric coordinates L and the coordinate x from -1 to 1 is at sum L_k ((1 - x) a_k + (1 + x) b_k) / 2.
struct Wedge {
  std::array<std::array<Eigen::Vector3d, 3>, 2> triangles;  ///< counter-clockwise, seen from the second one
};

/// A point of integration in a wedge.
struct WedgePoint {
  Eigen::Vector3d barycentric;
  double along;                           ///< the coordinate x
  Eigen::Matrix<double, 3, 4> gradients;  ///< gradients of the three barycentric coordinates and of x
  double weight;                          ///< the volume for which the point counts; negative where it is inverted
};

/// Points of integration, exact to the fourth order in the triangle and to the fifth in x.
[[nodiscard]] std::vector<WedgePoint> integration_points(const Wedge& wedge);

/// Barycentric coordinates and weights, of sum 1, of six points in a triangle, exact to the fourth order (Dunavant
/// 1985).
struct TriangleRule {
  std::array<Eigen::Vector3d, 6> points;
  std::array<double, 6> weights{};
};
[[nodiscard]] const TriangleRule& triangle_rule();

/// Quadratic functions of a triangle, of its corners and of the middles of its edges from the first, the second and the
/// third corner, and their derivatives by the barycentric coordinates, a row each.
[[nodiscard]] Eigen::Matrix<double, 6, 1> quadratic_in_triangle(const Eigen::Vector3d& barycentric);
[[nodiscard]] Eigen::Matrix<double, 3, 6> quadratic_slopes(const Eigen::Vector3d& barycentric);

}  // namespace breccia::films

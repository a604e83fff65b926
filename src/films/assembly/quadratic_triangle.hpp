#pragma once

#include <array>

#include <Eigen/Core>

#include "films/assembly/plane_strain.hpp"

namespace breccia::films {

/// A triangle with straight edges and quadratic functions of six nodes: three corners, then the middles of the edges
/// from the first, the second and the third corner.
struct QuadraticTriangle {
  std::array<Gradients, 3> at;  ///< gradients of the functions at three points of integration, which have equal weights
  std::array<Eigen::Vector3d, 3> linear_at;  ///< the linear functions of the corners at these points
  double area = 0.0;
};

/// `corners` are counter-clockwise.
[[nodiscard]] QuadraticTriangle quadratic_triangle(const std::array<Eigen::Vector2d, 3>& corners);

/// Stiffness for the displacements of the nodes, two components each, of a material with this stiffness (xx, yy,
/// engineering shear).
[[nodiscard]] Eigen::Matrix<double, 12, 12> triangle_stiffness(const QuadraticTriangle& triangle,
                                                               const Eigen::Matrix3d& elasticity);

}  // namespace breccia::films

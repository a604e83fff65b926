#include "films/assembly/quadratic_triangle.hpp"

#include <cstddef>

#include <Eigen/LU>

namespace breccia::films {

QuadraticTriangle quadratic_triangle(const std::array<Eigen::Vector2d, 3>& corners) {
  const auto& [a, b, c] = corners;
  Eigen::Matrix2d edges;
  edges << b - a, c - a;
  // Gradients of the barycentric coordinates.
  Eigen::Matrix<double, 2, 3> barycentric;
  barycentric.rightCols<2>() = edges.inverse().transpose();
  barycentric.col(0) = -barycentric.col(1) - barycentric.col(2);
  QuadraticTriangle result{{}, {}, 0.5 * edges.determinant()};
  for (int point = 0; point < 3; ++point) {
    Eigen::Vector3d l = Eigen::Vector3d::Constant(1.0 / 6.0);
    l[point] = 2.0 / 3.0;
    auto& gradients = result.at[static_cast<std::size_t>(point)];
    gradients.resize(2, 6);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      gradients.col(i) = (4.0 * l[i] - 1.0) * barycentric.col(i);
      gradients.col(3 + i) = 4.0 * (l[i] * barycentric.col(j) + l[j] * barycentric.col(i));
    }
    result.linear_at[static_cast<std::size_t>(point)] = l;
  }
  return result;
}

Eigen::Matrix<double, 12, 12> triangle_stiffness(const QuadraticTriangle& triangle, const Eigen::Matrix3d& elasticity) {
  Eigen::Matrix<double, 12, 12> stiffness = Eigen::Matrix<double, 12, 12>::Zero();
  for (const auto& gradients : triangle.at) {
    const auto strain = strain_rows(gradients);
    stiffness += triangle.area / 3.0 * strain.transpose() * elasticity * strain;
  }
  return stiffness;
}

}  // namespace breccia::films

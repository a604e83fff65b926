#include "assembly/grain_triangle.hpp"

#include <Eigen/LU>

namespace breccia::films {

TriangleGradients triangle_gradients(const GrainMesh& mesh, const std::array<std::size_t, 6>& nodes) {
  const auto &a = mesh.nodes[nodes[0]], &b = mesh.nodes[nodes[1]], &c = mesh.nodes[nodes[2]];
  Eigen::Matrix2d edges;
  edges << b - a, c - a;
  // Gradients of the barycentric coordinates.
  Eigen::Matrix<double, 2, 3> barycentric;
  barycentric.rightCols<2>() = edges.inverse().transpose();
  barycentric.col(0) = -barycentric.col(1) - barycentric.col(2);
  TriangleGradients result{{}, 0.5 * edges.determinant()};
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
  }
  return result;
}

}  // namespace breccia::films

#include "assembly/grain_stiffness.hpp"

#include <array>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "assembly/plane_strain.hpp"

namespace breccia::films {
namespace {

/// Gradients of the quadratic shape functions of a triangle, and its area.
struct TriangleGradients {
  std::array<Gradients, 3> at;  ///< at the three points of integration, of equal weights
  double area;
};

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

}  // namespace

Eigen::MatrixXd grain_stiffness(const GrainMesh& mesh, const Moduli& moduli) {
  const auto size = 2 * static_cast<Eigen::Index>(mesh.nodes.size());
  const auto outer = 2 * static_cast<Eigen::Index>(mesh.boundary_nodes), inner = size - outer;
  const auto elasticity = plane_strain_stiffness(moduli);
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(size, size);
  for (const auto& nodes : mesh.triangles) {
    const auto [at, area] = triangle_gradients(mesh, nodes);
    Eigen::Matrix<double, 12, 12> element = Eigen::Matrix<double, 12, 12>::Zero();
    for (const auto& gradients : at) {
      const auto strain = strain_rows(gradients);
      element += area / 3.0 * strain.transpose() * elasticity * strain;
    }
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        whole.block<2, 2>(2 * static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(i)]),
                          2 * static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(j)])) +=
            element.block<2, 2>(2 * i, 2 * j);
      }
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> inside(whole.bottomRightCorner(inner, inner));
  const Eigen::MatrixXd coupling = inside.matrixL().solve(whole.bottomLeftCorner(inner, outer));
  Eigen::MatrixXd condensed = whole.topLeftCorner(outer, outer);
  condensed.noalias() -= coupling.transpose() * coupling;
  return condensed;
}

}  // namespace breccia::films

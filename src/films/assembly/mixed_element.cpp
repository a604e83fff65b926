#include "films/assembly/mixed_element.hpp"

#include <cstddef>

#include <Eigen/LU>

#include "films/assembly/plane_strain.hpp"
#include "films/assembly/quadratic_triangle.hpp"
#include "films/assembly/quadrature.hpp"

namespace breccia::films {
namespace {

Eigen::Matrix3d unit_deviatoric_stiffness() {
  return plane_strain_stiffness({.bulk = 0.0, .shear = 1.0});
}

/// Places of the nine nodes in the square of three lines of three nodes each.
struct GridNode {
  int column, row;
};
constexpr std::array<GridNode, 9> nine_nodes = {
    {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}}};

}  // namespace

MixedElement mixed_triangle(const std::array<Eigen::Vector2d, 3>& corners) {
  const auto triangle = quadratic_triangle(corners);
  MixedElement element{triangle_stiffness(triangle, unit_deviatoric_stiffness()), Eigen::MatrixXd::Zero(3, 12),
                       Eigen::MatrixXd::Zero(3, 3)};
  for (std::size_t point = 0; point < triangle.at.size(); ++point) {
    const auto strain = strain_rows(triangle.at[point]);
    const auto& pressures = triangle.linear_at[point];
    element.dilatation += triangle.area / 3.0 * pressures * (strain.row(0) + strain.row(1));
    element.volume += triangle.area / 3.0 * pressures * pressures.transpose();
  }
  return element;
}

MixedElement mixed_quadrilateral(const std::array<Eigen::Vector2d, 4>& corners) {
  constexpr int nodes = 9, pressures = 4;
  MixedElement element{Eigen::MatrixXd::Zero(2 * nodes, 2 * nodes), Eigen::MatrixXd::Zero(pressures, 2 * nodes),
                       Eigen::MatrixXd::Zero(pressures, pressures)};
  const auto deviatoric = unit_deviatoric_stiffness();
  const auto& [points, weights] = gauss_rule();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      const double x = points[i], y = points[j];
      const auto along = linear(x), across = linear(y);
      const Eigen::Vector4d of_corners(along[0] * across[0], along[1] * across[0], along[1] * across[1],
                                       along[0] * across[1]);
      Eigen::Matrix2d jacobian;  // derivatives of the position by x and y
      jacobian << 0.5 * (across[0] * (corners[1] - corners[0]) + across[1] * (corners[2] - corners[3])),
          0.5 * (along[0] * (corners[3] - corners[0]) + along[1] * (corners[2] - corners[1]));
      Gradients gradients(2, nodes);
      const auto in_x = quadratic(x), in_y = quadratic(y), slope_x = quadratic_slope(x), slope_y = quadratic_slope(y);
      for (std::size_t n = 0; n < nine_nodes.size(); ++n) {
        const auto& [column, row] = nine_nodes[n];
        gradients.col(static_cast<Eigen::Index>(n)) << slope_x[column] * in_y[row], in_x[column] * slope_y[row];
      }
      const auto strain = strain_rows(jacobian.inverse().transpose() * gradients);
      const double area = weights[i] * weights[j] * jacobian.determinant();
      element.shear += area * strain.transpose() * deviatoric * strain;
      element.dilatation += area * of_corners * (strain.row(0) + strain.row(1));
      element.volume += area * of_corners * of_corners.transpose();
    }
  }
  return element;
}

}  // namespace breccia::films

#include "films/space/wedge.hpp"

#include <cmath>
#include <cstddef>

#include <Eigen/LU>

#include "films/assembly/quadrature.hpp"

namespace breccia::films {

const TriangleRule& triangle_rule() {
  static const TriangleRule rule = [] {
    const double root = std::sqrt(38.0 - 44.0 * std::sqrt(0.4));
    const double root_of_weights = std::sqrt(213125.0 - 53320.0 * std::sqrt(10.0));
    TriangleRule made;
    for (std::size_t orbit = 0; orbit < 2; ++orbit) {
      const double sign = orbit == 0 ? 1.0 : -1.0;
      const double near = (8.0 - std::sqrt(10.0) + sign * root) / 18.0;
      for (int corner = 0; corner < 3; ++corner) {
        const auto i = 3 * orbit + static_cast<std::size_t>(corner);
        made.points[i] = Eigen::Vector3d::Constant(near);
        made.points[i][corner] = 1.0 - 2.0 * near;
        made.weights[i] = (620.0 + sign * root_of_weights) / 3720.0;
      }
    }
    return made;
  }();
  return rule;
}

std::vector<WedgePoint> integration_points(const Wedge& wedge) {
  const auto& [places, weights] = triangle_rule();
  const auto& [gauss_points, gauss_weights] = gauss_rule();
  const auto& [first, second] = wedge.triangles;
  std::vector<WedgePoint> points;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < gauss_points.size(); ++j) {
      const auto share = linear(gauss_points[j]);
      // Derivatives of the position by the second and the third barycentric coordinate, the first being 1 minus them,
      // and by x.
      Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
      for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d position = share[0] * first[k] + share[1] * second[k];
        if (k == 0) {
          jacobian.leftCols<2>().colwise() -= position;
        } else {
          jacobian.col(static_cast<Eigen::Index>(k) - 1) += position;
        }
        jacobian.col(2) += 0.5 * places[i][static_cast<Eigen::Index>(k)] * (second[k] - first[k]);
      }
      WedgePoint point{places[i], gauss_points[j], {}, 0.5 * weights[i] * gauss_weights[j] * jacobian.determinant()};
      point.gradients.rightCols<3>() = jacobian.inverse().transpose();
      point.gradients.col(0) = -point.gradients.col(1) - point.gradients.col(2);
      points.push_back(point);
    }
  }
  return points;
}

Eigen::Matrix<double, 6, 1> quadratic_in_triangle(const Eigen::Vector3d& barycentric) {
  const auto& l = barycentric;
  Eigen::Matrix<double, 6, 1> values;
  for (int i = 0; i < 3; ++i) {
    values[i] = l[i] * (2.0 * l[i] - 1.0);
    values[3 + i] = 4.0 * l[i] * l[(i + 1) % 3];
  }
  return values;
}

Eigen::Matrix<double, 3, 6> quadratic_slopes(const Eigen::Vector3d& barycentric) {
  const auto& l = barycentric;
  Eigen::Matrix<double, 3, 6> slopes = Eigen::Matrix<double, 3, 6>::Zero();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    slopes(i, i) = 4.0 * l[i] - 1.0;
    slopes(i, 3 + i) = 4.0 * l[j];
    slopes(j, 3 + i) = 4.0 * l[i];
  }
  return slopes;
}

}  // namespace breccia::films

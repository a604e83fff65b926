#include "films/assembly/junction_element.hpp"

#include <array>
#include <cmath>

#include "films/assembly/plane_strain.hpp"

namespace breccia::films {

JunctionElement junction_element(std::span<const Eigen::Vector2d> corners) {
  const auto size = 2 * static_cast<Eigen::Index>(corners.size());
  JunctionElement element{Eigen::MatrixXd::Zero(size, size), Eigen::RowVectorXd::Zero(size), 0.0};
  const auto deviatoric = plane_strain_stiffness({.bulk = 0.0, .shear = 1.0});
  for (std::size_t second = 1; second + 1 < corners.size(); ++second) {
    const std::array<std::size_t, 3> of_triangle = {0, second, second + 1};
    Gradients twice_area_gradients(2, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector2d opposite = corners[of_triangle[(i + 2) % 3]] - corners[of_triangle[(i + 1) % 3]];
      twice_area_gradients.col(static_cast<Eigen::Index>(i)) << -opposite.y(), opposite.x();
    }
    const Eigen::Vector2d a = corners[second] - corners[0], b = corners[second + 1] - corners[0];
    const double twice_area = a.x() * b.y() - a.y() * b.x();
    element.area += 0.5 * twice_area;
    const auto strain = strain_rows(twice_area_gradients);
    // Next to a vanished face three corners may be almost on a line, or a triangle may be inverted.
    constexpr double least_share = 1e-6;
    const double size_of_triangle = std::max(std::abs(twice_area), least_share * (a.squaredNorm() + b.squaredNorm()));
    const Eigen::Matrix<double, 6, 6> shear = 0.5 / size_of_triangle * strain.transpose() * deviatoric * strain;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = 2 * static_cast<Eigen::Index>(of_triangle[i]);
      element.dilatation.segment<2>(row) += 0.5 * twice_area_gradients.col(static_cast<Eigen::Index>(i)).transpose();
      for (std::size_t j = 0; j < 3; ++j) {
        const auto column = 2 * static_cast<Eigen::Index>(of_triangle[j]);
        element.shear.block<2, 2>(row, column) +=
            shear.block<2, 2>(2 * static_cast<Eigen::Index>(i), 2 * static_cast<Eigen::Index>(j));
      }
    }
  }
  return element;
}

}  // namespace breccia::films

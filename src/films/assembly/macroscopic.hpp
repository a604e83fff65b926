#pragma once

#include <Eigen/Core>

#include "breccia/discretisation/load.hpp"

namespace breccia::films {

/// Components of the macroscopic strain of a load: xx, yy and the engineering shear.
[[nodiscard]] inline Eigen::Vector3d strain_of(Load load) {
  const auto strain = unit_strain<2>(load);
  return {strain.xx, strain.yy, 2.0 * strain.xy};
}

/// Matrix that gives the displacement at a position from the macroscopic strains xx, yy and the engineering shear.
[[nodiscard]] inline Eigen::Matrix<double, 2, 3> affine_motion(const Eigen::Vector2d& position) {
  Eigen::Matrix<double, 2, 3> motion;
  motion << position.x(), 0.0, 0.5 * position.y(), 0.0, position.y(), 0.5 * position.x();
  return motion;
}

}  // namespace breccia::films

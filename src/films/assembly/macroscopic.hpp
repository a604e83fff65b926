#pragma once

#include <Eigen/Core>

#include "breccia/discretisation/load.hpp"

namespace breccia::films {

/// Components of the macroscopic strain of a load: xx, yy and the engineering shear.
[[nodiscard]] inline Eigen::Vector3d strain_of(Load load) {
  const auto strain = unit_strain<2>(load);
  return {strain.xx, strain.yy, 2.0 * strain.xy};
}

/// Displacement at a place by the macroscopic strains xx, yy and the engineering shear.
[[nodiscard]] inline Eigen::Matrix<double, 2, 3> affine_motion(const Eigen::Vector2d& place) {
  Eigen::Matrix<double, 2, 3> motion;
  motion << place.x(), 0.0, 0.5 * place.y(), 0.0, place.y(), 0.5 * place.x();
  return motion;
}

}  // namespace breccia::films

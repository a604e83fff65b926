#pragma once

#include <Eigen/Core>

#include "breccia/discretisation/load.hpp"

namespace breccia::films {

/// The macroscopic strains: those of the axes, then the engineering shears, in Voigt's order.
template <int dim>
using StrainVector = Eigen::Matrix<double, tensor_components<dim>, 1>;

/// Components of the macroscopic strain of a load.
template <int dim>
[[nodiscard]] StrainVector<dim> strain_of(Load load) {
  const auto strain = unit_strain<dim>(load);
  StrainVector<dim> components;
  for (int i = 0; i < tensor_components<dim>; ++i) components[i] = (i < dim ? 1.0 : 2.0) * component(strain, i);
  return components;
}

/// Matrix that gives the displacement at a position from the macroscopic strains xx, yy and the engineering shear.
[[nodiscard]] inline Eigen::Matrix<double, 2, 3> affine_motion(const Eigen::Vector2d& position) {
  Eigen::Matrix<double, 2, 3> motion;
  motion << position.x(), 0.0, 0.5 * position.y(), 0.0, position.y(), 0.5 * position.x();
  return motion;
}

/// Matrix that gives the displacement at a position from the macroscopic strains in space.
[[nodiscard]] inline Eigen::Matrix<double, 3, 6> affine_motion_in_space(const Eigen::Vector3d& position) {
  const double x = position.x(), y = position.y(), z = position.z();
  Eigen::Matrix<double, 3, 6> motion;
  motion << x, 0.0, 0.0, 0.0, 0.5 * z, 0.5 * y,  //
      0.0, y, 0.0, 0.5 * z, 0.0, 0.5 * x,        //
      0.0, 0.0, z, 0.5 * y, 0.5 * x, 0.0;
  return motion;
}

}  // namespace breccia::films

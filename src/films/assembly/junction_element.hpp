#pragma once

#include <span>

#include <Eigen/Core>

namespace breccia::films {

/// Matrices of the binder between the corners of grains (theory, Eq. 64): triangles from the first corner, with linear
/// displacements. The unknowns are the displacements of the corners, two components each.
struct JunctionElement {
  Eigen::MatrixXd shear;          ///< stiffness of a unit shear modulus
  Eigen::RowVectorXd dilatation;  ///< change of area
  double area;
};

/// `corners` are the corners of a polygon, counter-clockwise. Two corners alone have no area between them.
[[nodiscard]] JunctionElement junction_element(std::span<const Eigen::Vector2d> corners);

}  // namespace breccia::films

#pragma once

#include <array>

#include <Eigen/Core>

namespace breccia::films {

/// Matrices of an element of Taylor and Hood, with quadratic displacements and linear pressures (theory, Eq. 66a). The
/// unknowns are the displacements of its nodes, two components each, and the pressures at its corners.
struct MixedElement {
  Eigen::MatrixXd shear;       ///< stiffness of a unit shear modulus
  Eigen::MatrixXd dilatation;  ///< volume change, weighted by the functions of the pressures
  Eigen::MatrixXd volume;      ///< integrals of products of these functions
};

/// The element of a triangle with straight edges and six nodes (see QuadraticTriangle).
[[nodiscard]] MixedElement mixed_triangle(const std::array<Eigen::Vector2d, 3>& corners);

/// The element of a convex quadrilateral with straight edges and nine nodes: four corners counter-clockwise, the
/// middles of the edges that start at them, and the centre, where the lines between the middles of opposite edges meet.
[[nodiscard]] MixedElement mixed_quadrilateral(const std::array<Eigen::Vector2d, 4>& corners);

}  // namespace breccia::films

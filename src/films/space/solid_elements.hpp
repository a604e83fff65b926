#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "breccia/discretisation/moduli.hpp"

namespace breccia::films {

using TetrahedronCorners = std::array<Eigen::Vector3d, 4>;

/// The edges of a tetrahedron by their two corners, in the order of the nodes in their middles.
inline constexpr std::array<std::array<std::size_t, 2>, 6> edges_of_tetrahedron = {
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// Volume of a tetrahedron; negative where it is inverted.
[[nodiscard]] double volume_of(const TetrahedronCorners& corners);

/// Matrices of an element of binder of any kind, whose unknowns are displacements of nodes, three components each.
struct BinderElement {
  Eigen::MatrixXd shear;       ///< stiffness of a unit shear modulus
  Eigen::MatrixXd dilatation;  ///< volume change, weighted by the functions of the pressures
  Eigen::MatrixXd volume;      ///< integrals of products of these functions
  Eigen::MatrixXd strain;      ///< integral of the strain, in Voigt's order
};

/// Stiffness of a tetrahedron with straight edges and quadratic displacements, of a material of this elasticity for
/// strains in Voigt's order.
[[nodiscard]] Eigen::Matrix<double, 30, 30> tetrahedron_stiffness(const TetrahedronCorners& corners,
                                                                  const Eigen::Matrix<double, 6, 6>& elasticity);

/// The integral of the strain, in Voigt's order, over such a tetrahedron.
[[nodiscard]] Eigen::Matrix<double, 6, 30> tetrahedron_strain(const TetrahedronCorners& corners);

/// A tetrahedron with straight edges, quadratic displacements and linear pressures (Taylor and Hood).
[[nodiscard]] BinderElement taylor_hood_element(const TetrahedronCorners& corners);

/// The channel along an edge of the cells between three grains (theory, Eq. 69d). `ends` are, for each grain, the start
/// and the end of its edge. The nodes are the start, the middle and the end of the edge of the first grain, then of the
/// second and the third one; the pressures are at start, middle and end.
[[nodiscard]] BinderElement channel_element(const std::array<std::array<Eigen::Vector3d, 2>, 3>& ends);

/// The tetrahedron between the corners of four grains, with linear displacements and one pressure (theory, Eq. 69d).
[[nodiscard]] BinderElement corner_element(const TetrahedronCorners& corners);

}  // namespace breccia::films

#pragma once

#include <Eigen/Core>

#include "films/space/wedge.hpp"

namespace breccia::films {

/// Matrices of a triangle of a film in space (theory, Eq. 69c). Its unknowns are the displacements of six nodes on the
/// first side, then on the second side, three components each; then the flows at the three corners, two components each
/// along `axes`. Its six pressures are those of the nodes.
struct FilmWedge {
  static constexpr int displacements = 36, flows = 6, pressures = 6, unknowns = displacements + flows;

  Eigen::Matrix<double, unknowns, unknowns> shear;        ///< stiffness of a unit shear modulus
  Eigen::Matrix<double, pressures, unknowns> dilatation;  ///< volume change, weighted by the functions of the pressure
  Eigen::Matrix<double, pressures, pressures> volume;     ///< integrals of products of these functions
  Eigen::Matrix<double, 6, displacements> strain;         ///< integral of the strain without the flow, in Voigt's order
  Eigen::Matrix<double, 3, 2> axes;                       ///< directions in the middle of the film, of length 1
};

/// The directions along the middle of a film (FilmWedge::axes). Their vector product is its normal, from the first
/// side.
[[nodiscard]] Eigen::Matrix<double, 3, 2> film_axes(const Wedge& wedge);
/// `is_at_rim`: the edge from the second to the third corner is the end of the film, where its flow bends into a
/// channel.
[[nodiscard]] FilmWedge film_wedge(const Wedge& wedge, bool is_at_rim);
/// The matrices of a triangle whose binder slides along its second side (theory, Eqs. 61a and 69c).
[[nodiscard]] FilmWedge sliding_film_wedge(const Wedge& wedge, bool is_at_rim);

/// The volume that leaves a triangle at the rim where the nodes on its second side move and those on its first side do
/// not, by the six pressures and the displacements of the second side.
[[nodiscard]] Eigen::Matrix<double, FilmWedge::pressures, FilmWedge::displacements / 2> outflow_of_second_side(
    const Wedge& wedge);

}  // namespace breccia::films

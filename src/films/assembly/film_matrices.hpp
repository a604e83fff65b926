#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace breccia::films {

/// Number of an unknown that a boundary holds at zero.
inline constexpr int held = -1;

/// The matrices of grains and films (theory, Eq. 65), in units of the side of the box. The unknowns are displacements
/// and, for thin films, flows, followed by the macroscopic strains xx, yy and the engineering shear.
struct FilmMatrices {
  using Sparse = Eigen::SparseMatrix<double>;
  static constexpr int macroscopic = 3;  ///< number of macroscopic strains

  Sparse grains;                                       ///< lower triangle of K_0, at the moduli of the grains [Pa]
  Sparse shear;                                        ///< lower triangle of K_G, of a unit shear modulus of the binder
  Sparse dilatation;                                   ///< volume change by pressure and unknown
  Sparse volume;                                       ///< lower triangle of the products of the pressures' functions
  Eigen::Matrix<double, Eigen::Dynamic, 3> tractions;  ///< forces of the stresses xx, yy and xy on the boundary
  /// Values of the unknowns in the displacement gradients 11, 12, 21 and 22.
  Eigen::Matrix<double, Eigen::Dynamic, 4> by_gradient;
  /// Vector from the first node to the node whose second component a traction boundary holds at zero.
  Eigen::Vector2d farthest_held = Eigen::Vector2d::Zero();
  double area = 0.0;  ///< area of grains and binder in a box of area 1
};

}  // namespace breccia::films

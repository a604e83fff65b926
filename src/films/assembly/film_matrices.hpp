#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "breccia/discretisation/tensor.hpp"

namespace breccia::films {

/// Number of an unknown that a boundary holds at zero.
inline constexpr int held = -1;

/// The matrices of grains and films (theory, Eq. 65), in units of the side of the box. The unknowns are displacements
/// and, for thin films, flows, followed by the macroscopic strains in Voigt's order, with engineering shears.
template <int dim>
struct FilmMatrices {
  using Sparse = Eigen::SparseMatrix<double>;
  static constexpr int macroscopic = tensor_components<dim>;  ///< number of macroscopic strains
  using ByStrain = Eigen::Matrix<double, Eigen::Dynamic, macroscopic>;

  Sparse grains;       ///< lower triangle of K_0, at the moduli of the grains [Pa]
  Sparse shear;        ///< lower triangle of K_G, of a unit shear modulus of the binder
  Sparse dilatation;   ///< volume change by pressure and unknown
  Sparse volume;       ///< lower triangle of the products of the pressures' functions
  ByStrain tractions;  ///< forces of the stresses, in Voigt's order, on the boundary
  /// Values of the unknowns in the displacement gradients 11, 12, 21 and 22.
  Eigen::Matrix<double, Eigen::Dynamic, dim * dim> by_gradient;
  /// Vector from the first node to the node whose second component a traction boundary holds at zero.
  Eigen::Matrix<double, dim, 1> farthest_held = Eigen::Matrix<double, dim, 1>::Zero();
  /// Area, in space volume, of grains and binder in a box of 1: without gaps, and of films that slide the work for
  /// which they count in a uniform shear.
  double content = 0.0;
  double content_of_grains = 0.0;  ///< the part of the content that is grains
  double shear_of_grains = 0.0;    ///< sum of the contents of grains, each times its modulus under the load shear [Pa]
};

}  // namespace breccia::films

#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "mesh.hpp"
#include "packing.hpp"
#include "unknowns.hpp"

namespace disc_packings {

/// The macroscopic strains E: diag(1/2, -1/2), E_xy = E_yx = 1/2, diag(1/2, 1/2). The stress of a load is 2 E, where
/// the tractions are given.
struct Load {
  const char* name;
  Eigen::Matrix2d strain;
};
[[nodiscard]] const std::array<Load, 3>& loads();

/// Twice the energy of an element at the macroscopic strain of load l and the fluctuations u of its unknowns is
///
///   G (u . shear u + 2 u . shear_loads_l + shear_energies_l) + (K - 2/3 G) |dilatation u + dilatation_loads_l|^2,
///
/// with its moduli K and G: the integral of 2 G e : e + (K - 2/3 G) (div u)^2. The divergence is projected on the
/// polynomials that the pressure may be, of one order less than the displacements, without continuity from element to
/// element; the rows of the dilatation are its components in an orthonormal basis.
///
/// The work of the stress of load l on the strains of u is u . stress_forces_l.
struct ElementMatrices {
  Region region;
  double area;
  std::vector<int> unknowns;
  Eigen::MatrixX2d translations;  ///< unknowns of translations along x and y
  Eigen::MatrixXd shear, dilatation;
  Eigen::MatrixX3d shear_loads, dilatation_loads;
  Eigen::MatrixX3d stress_forces;
  Eigen::Vector3d shear_energies;
};
[[nodiscard]] std::vector<ElementMatrices> element_matrices(const Mesh& mesh, const Packing& packing,
                                                            const Unknowns& unknowns, int order);

}  // namespace disc_packings

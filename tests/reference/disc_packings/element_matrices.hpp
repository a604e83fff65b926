#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "mesh.hpp"
#include "packing.hpp"

namespace disc_packings {

/// The macroscopic strains: diag(1/2, -1/2), E_xy = E_yx = 1/2, diag(1/2, 1/2).
struct Load {
  const char* name;
  Eigen::Matrix2d strain;
};
[[nodiscard]] const std::array<Load, 3>& loads();

/// The unknowns of a mesh are the fluctuations of the displacement, which are periodic: x and y of every node, but of
/// a rigid disc x, y and the turn (times the radius) in place of the nodes on its circle.
struct Unknowns {
  int count;
  std::vector<int> first_of_node;  ///< -1: the node follows its rigid disc
};
[[nodiscard]] Unknowns number_unknowns(const Mesh& mesh, const Packing& packing, Filler filler);

/// Twice the energy of an element at the macroscopic strain of load l and the fluctuations u of its unknowns is
///
///   G (u . shear u + 2 u . shear_loads_l + shear_energies_l) + (K - 2/3 G) |dilatation u + dilatation_loads_l|^2,
///
/// with its moduli K and G: the integral of 2 G e : e + (K - 2/3 G) (div u)^2. The divergence is projected on the
/// polynomials that the pressure may be, of one order less than the displacements, without continuity from element to
/// element; the rows of the dilatation are its components in an orthonormal basis.
struct ElementMatrices {
  Region region;
  double area;
  std::vector<int> unknowns;
  Eigen::MatrixX2d translations;  ///< unknowns of translations along x and y
  Eigen::MatrixXd shear, dilatation;
  Eigen::MatrixX3d shear_loads, dilatation_loads;
  Eigen::Vector3d shear_energies;
};
[[nodiscard]] std::vector<ElementMatrices> element_matrices(const Mesh& mesh, const Packing& packing,
                                                            const Unknowns& unknowns, int order);

}  // namespace disc_packings

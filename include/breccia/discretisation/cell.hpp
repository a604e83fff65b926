#pragma once

#include <array>

#include <Eigen/Dense>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/volumetric.hpp"

namespace breccia {

/// Degrees of freedom of a cell: x and y of its four nodes in turn.
constexpr int cell_dofs = 8;

using CellVector = Eigen::Matrix<double, cell_dofs, 1>;
using CellMatrix = Eigen::Matrix<double, cell_dofs, cell_dofs>;

/// Weights of the four nodes at a material point (bilinear shape functions): 9/16, 3/16, 3/16, 1/16 in the point's
/// order.
std::array<double, 4> node_weights(int point);

/// Strain (xx, yy, engineering xy) at a point from the nodal displacements in units of the cell side (theory, Eq. 3).
Eigen::Matrix<double, 3, cell_dofs> strain_matrix(int point);

/// The same as the stress of the point sees it: its in-plane volumetric part xx + yy is the point's own or the mean of
/// the cell (theory, Eq. 4).
Eigen::Matrix<double, 3, cell_dofs> strain_matrix(int point, Volumetric volumetric);

/// Volumetric strain xx + yy that the stress of the point sees.
Eigen::Matrix<double, 1, cell_dofs> volumetric_strain_matrix(int point, Volumetric volumetric);

/// Elastic moduli of one point.
struct Moduli {
  double bulk;   ///< [Pa]
  double shear;  ///< [Pa]
};

/// Stiffness of a cell per unit thickness [Pa]: nodal forces per thickness [N/m] from nodal displacements [m]. In two
/// dimensions it does not depend on the cell side (theory, Eq. 5).
CellMatrix cell_stiffness(const std::array<Moduli, points_per_cell>& moduli, Volumetric volumetric);

}  // namespace breccia

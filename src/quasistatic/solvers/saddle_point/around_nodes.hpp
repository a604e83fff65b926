#pragma once

#include <cstddef>
#include <vector>

#include "breccia/discretisation/moduli.hpp"

#include "discretisation/cell_shape.hpp"
#include "quasistatic/operator/cell_sweep.hpp"
#include "quasistatic/solvers/lattice/nodal_field.hpp"

namespace breccia::quasistatic {

/// A node of a cell of a periodic box: behind the last node along an axis comes the first one.
[[nodiscard]] Index<3> node_of_cell(const NodeLattice& lattice, const Index<3>& cell, int node) noexcept;

/// The index of a node of a cell of a periodic box among the entries of a component.
[[nodiscard]] std::size_t index_of_node(const NodeLattice& lattice, const Index<3>& cell, int node) noexcept;

/// The stiffness [Pa] of a cube of side 1 with averaged volumetric strains.
[[nodiscard]] CellShape<3>::Stiffness stiffness_of_cube(const Moduli& moduli);

/// The mean shear modulus of the cells around each node of a periodic box [Pa], by entry of a component.
[[nodiscard]] std::vector<double> shear_around_nodes(const NodeLattice& lattice, const CellModuli& cells);

/// The diagonal of the stiffness of a periodic box [Pa], which all components of a node share, by entry of a component.
[[nodiscard]] std::vector<double> diagonal_of_nodes(const NodeLattice& lattice, const CellModuli& cells);

}  // namespace breccia::quasistatic

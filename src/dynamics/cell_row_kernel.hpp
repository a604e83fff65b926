#pragma once

// The inner loops of the total-lagrangian formulation: the internal forces of one row of cells, and the motion of one
// row of nodes.
//
// A square cell strains in five ways: xx, yy and xy of its centre, and two hourglass modes, the gradients q_u and q_v
// of the two displacement components along the diagonal; a cube strains in eighteen (theory, Eq. 6 and 73). The strains
// of all its points follow from these, and so do their histories, since a hereditary stress is linear in the strain: a
// Maxwell term needs five or eighteen numbers a cell and material, whatever the number of points.
//
// Cells come in blocks of eight, whatever the width of a register; the arithmetic is the same on every instruction set.
// This header is compiled for several instruction sets: it defines plain data only.

#include <cstddef>
#include <cstdint>

namespace breccia::dynamics {

constexpr int lanes = 8;  ///< cells in a block

/// One step of a Maxwell term for a strain linear in the step: h' = decay h + gain de.
struct TermStep {
  double decay;
  double gain;  ///< [Pa]
};

/// A material as the kernel sees it.
struct MaterialStep {
  double bulk;   ///< equilibrium bulk modulus [Pa]
  double shear;  ///< equilibrium shear modulus [Pa]
  const TermStep* shear_terms;
  const TermStep* bulk_terms;
  int shear_term_count;
  int bulk_term_count;
};

/// The points of a block that have one material; bit p of points[lane] stands for the point p of the cell in that lane.
struct Share {
  const MaterialStep* material;
  double* history;             ///< terms x modes x lanes, or nullptr where the material is elastic
  std::uint8_t points[lanes];  // NOLINT(modernize-avoid-c-arrays): see above
};

/// The material of a whole cell. Its dilatational modulus is that of equal strains along all axes: K + G/3 in plane
/// strain, which has terms of its own, so that a mixture of phases needs no more terms than its phases have, and K in 3
/// dimensions. Lists of terms are filled up with zeros to one length.
struct CellMaterialStep {
  double dilatational;  ///< equilibrium dilatational modulus [Pa]
  double shear;         ///< equilibrium shear modulus [Pa]
  const TermStep* shear_terms;
  const TermStep* dilatational_terms;
  int shear_term_count;  ///< number of shear terms without the zeros
  int dilatational_term_count;
};

/// Eight cells of one material each, but not all of the same one: cells along an interface, with mixed cells.
struct CellMaterials {
  const CellMaterialStep* of_lane[lanes];  // NOLINT(modernize-avoid-c-arrays): see above
  double* history;                         ///< (shear terms x shear_modes + dilatational terms) x lanes
  int shear_term_count;
  int dilatational_term_count;
};

/// Eight neighbouring cells of a row.
struct Block {
  const Share* shares;
  const CellMaterials* by_cell;  ///< materials of the cells in place of shares, or nullptr
  int share_count;
  bool uniform;  ///< every point of the block is of the one material
  bool relaxes;  ///< at least one material has history
};

template <int dim>
constexpr int axis_count = dim;

// NOLINTBEGIN(modernize-avoid-c-arrays): see above
/// Components of nodal values along a row of nodes.
template <int dim>
struct NodeValues {
  const double* of_axis[axis_count<dim>];
};

/// Components of the forces of a layer of cells, a row in 2 dimensions and a plane in 3, on the layer of nodes below or
/// above it: the sums of the forces of all of its cells, one row of nodes after the other.
template <int dim>
struct LayerForces {
  double* of_axis[axis_count<dim>];
};

/// Rows of nodes around a row of cells. The bits of the number of such a row are its sides along y and z.
template <int dim>
constexpr int rows_of_nodes = dim == 2 ? 2 : 4;

/// Whether the forces on a row of nodes are added to earlier ones, or written. In 3 dimensions rows of cells are taken
/// by rising y: forces on the rows of nodes on the lower side along y are added to those of the row of cells before. On
/// all other rows they are written.
template <int dim>
constexpr bool adds_to_row(int row) {
  return dim == 3 && (row & 1) == 0;
}

/// One row of cells and the rows of nodes around it.
template <int dim>
struct CellRow {
  const Block* blocks;
  int block_count;
  NodeValues<dim> displacement[rows_of_nodes<dim>];
  NodeValues<dim> increment[rows_of_nodes<dim>];  ///< displacement of this step minus that of the step before
  LayerForces<dim> force[rows_of_nodes<dim>];     ///< forces divided by h^(dim - 2)
  double* stress;  ///< sums in Voigt's order over the points of the row, times the cell side
};

/// A row of nodes to be moved: d += step_over_mass f, u += d, where f is the sum of the forces of the cells around,
/// divided by h^(dim - 2).
template <int dim>
struct NodeRow {
  int count;  ///< a multiple of the lanes
  double* displacement[axis_count<dim>];
  double* increment[axis_count<dim>];
  const double* step_over_mass;  ///< dt^2 h^(dim - 2) / m [m^(dim - 1)/N], zero where the motion is prescribed
  LayerForces<dim> from_cells_below;
  LayerForces<dim> from_cells_above;
};
// NOLINTEND(modernize-avoid-c-arrays)

/// Strain modes of a cell, each with a history of its own (CellShape::modes).
template <int dim>
constexpr int shear_modes = dim == 2 ? 5 : 18;
/// Modes of the bulk history: the volumetric strain of the centre and, for standard points, those hourglass modes that
/// change the volume.
template <int dim>
constexpr int bulk_modes_standard = dim == 2 ? 3 : 7;
constexpr int bulk_modes_averaged = 1;

/// Components of a symmetric tensor, in Voigt's order; the first strain modes of a cell are those of its centre.
template <int dim>
constexpr int strain_components = dim == 2 ? 3 : 6;

template <int dim>
struct KernelTable {
  void (*cell_row_averaged)(const CellRow<dim>&);
  void (*cell_row_standard)(const CellRow<dim>&);
  void (*node_row)(const NodeRow<dim>&);
};

/// The kernels of one instruction set.
struct Kernels {
  KernelTable<2> squares;
  KernelTable<3> cubes;
};

}  // namespace breccia::dynamics

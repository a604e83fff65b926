#pragma once

// The inner loop of the total-lagrangian formulation: the internal forces of one row of cells.
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

/// The points of a block that are of one material; bit p of points[lane] stands for point p of that cell.
struct Share {
  const MaterialStep* material;
  double* history;             ///< terms x modes x lanes, or nullptr where the material is elastic
  std::uint8_t points[lanes];  // NOLINT(modernize-avoid-c-arrays): see above
};

/// The material of a whole cell. Its dilatational modulus is that of equal strains along all axes: K + G/3 in plane
/// strain, which has terms of its own, so that a mixture of phases needs no more of them than its phases have, and K in
/// 3 dimensions. Lists of terms are filled up with zeros to one length.
struct CellMaterialStep {
  double dilatational;  ///< in equilibrium [Pa]
  double shear;         ///< equilibrium shear modulus [Pa]
  const TermStep* shear_terms;
  const TermStep* dilatational_terms;
  int shear_term_count;  ///< without the zeros
  int dilatational_term_count;
};

/// Eight cells of which each has one material, not all the same: those along an interface, with mixed cells.
struct CellMaterials {
  const CellMaterialStep* of_lane[lanes];  // NOLINT(modernize-avoid-c-arrays): see above
  double* history;                         ///< (shear terms x shear_modes + dilatational terms) x lanes
  int shear_term_count;
  int dilatational_term_count;
};

/// Eight neighbouring cells of a row.
struct Block {
  const Share* shares;
  const CellMaterials* by_cell;  ///< in place of shares; or nullptr
  int share_count;
  bool uniform;  ///< every point of the block is of the one material
  bool relaxes;  ///< at least one material has history
};

/// Components of nodal values along a row of nodes.
template <int dim>
struct NodeValues;

template <>
struct NodeValues<2> {
  const double* x;
  const double* y;
};

/// Forces of a layer of cells, a row in 2 dimensions and a plane in 3, on the layer of nodes below or above it.
template <int dim>
struct LayerForces;

/// Those from the cells to the right of a node ("left" nodes of their cells), and those from the cells to its left.
template <>
struct LayerForces<2> {
  double* left_x;
  double* left_y;
  double* right_x;
  double* right_y;
};

/// One row of cells and the rows of nodes it hangs on.
template <int dim>
struct CellRow;

template <>
struct CellRow<2> {
  const Block* blocks;
  int block_count;
  NodeValues<2> displacement_below;
  NodeValues<2> displacement_above;
  NodeValues<2> increment_below;  ///< displacement of this step minus that of the step before
  NodeValues<2> increment_above;
  LayerForces<2> below;
  LayerForces<2> above;
  double* stress;  ///< sums of xx, yy and xy over the row's points, times the cell side
};

/// Row of nodes to be moved: d += step_over_mass f, u += d, with f the sum of the forces of the cells around, which are
/// divided by h^(dim - 2).
template <int dim>
struct NodeRow;

template <>
struct NodeRow<2> {
  int count;  ///< a multiple of the lanes
  double* displacement_x;
  double* displacement_y;
  double* increment_x;
  double* increment_y;
  const double* step_over_mass;  ///< dt^2 / m [m/N per unit thickness], zero where the motion is prescribed
  LayerForces<2> from_cells_below;
  LayerForces<2> from_cells_above;
};

/// Strain modes of a cell, each with a history of its own (CellShape::modes).
template <int dim>
constexpr int shear_modes = dim == 2 ? 5 : 18;
/// Modes of the bulk history: the volumetric strain of the centre and, for standard points, those hourglass modes that
/// change the volume.
template <int dim>
constexpr int bulk_modes_standard = dim == 2 ? 3 : 7;
constexpr int bulk_modes_averaged = 1;

template <int dim>
struct KernelTable {
  void (*cell_row_averaged)(const CellRow<dim>&);
  void (*cell_row_standard)(const CellRow<dim>&);
  void (*node_row)(const NodeRow<dim>&);
};

}  // namespace breccia::dynamics

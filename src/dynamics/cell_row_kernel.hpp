#pragma once

// The inner loop of the total-lagrangian formulation: the internal forces of one row of cells.
//
// A cell strains in five ways: xx, yy and xy of its centre, and two hourglass modes, the gradients q_u and q_v of the
// two displacement components along the diagonal. All its points' strains follow from these five (theory, Eq. 6), and
// so do their histories, since a hereditary stress is linear in the strain: a Maxwell term needs five numbers a cell
// and material, whatever the number of points.
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

/// The material of a whole cell in plane strain. The modulus of equal strains along both axes, K + G/3, has terms of
/// its own, so that a mixture of phases needs no more of them than its phases have. Lists of terms are filled up with
/// zeros to one length.
struct CellMaterialStep {
  double dilatational;  ///< equilibrium of K + G/3 [Pa]
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

/// A pair of components of nodal values along a row of nodes.
struct NodeValues {
  const double* x;
  const double* y;
};

/// Forces of a row of cells on the nodes below and above, from the cells to the right of the node ("left" nodes of
/// their cells) and from those to its left.
struct RowForces {
  double* left_x;
  double* left_y;
  double* right_x;
  double* right_y;
};

/// One row of cells and the two rows of nodes it hangs on.
struct CellRow {
  const Block* blocks;
  int block_count;
  NodeValues displacement_below;
  NodeValues displacement_above;
  NodeValues increment_below;  ///< displacement of this step minus that of the step before
  NodeValues increment_above;
  RowForces below;
  RowForces above;
  double* stress;  ///< sums of xx, yy and xy over the row's points, times the cell side
};

/// Row of nodes to be moved: d += step_over_mass f, u += d, with f the sum of four contributions of the cells around.
struct NodeRow {
  int count;  ///< a multiple of the lanes
  double* displacement_x;
  double* displacement_y;
  double* increment_x;
  double* increment_y;
  const double* step_over_mass;  ///< dt^2 / m [m/N per unit thickness], zero where the motion is prescribed
  RowForces from_cells_below;
  RowForces from_cells_above;
};

/// Modes of the bulk history: the volumetric strain of the centre and, for standard points, two hourglass modes.
constexpr int bulk_modes_standard = 3;
constexpr int bulk_modes_averaged = 1;
constexpr int shear_modes = 5;

struct KernelTable {
  void (*cell_row_averaged)(const CellRow&);
  void (*cell_row_standard)(const CellRow&);
  void (*node_row)(const NodeRow&);
};

}  // namespace breccia::dynamics

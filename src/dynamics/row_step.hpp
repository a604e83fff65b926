#pragma once

#include <cstdint>

#include "breccia/dynamics/dynamic_problem.hpp"
#include "breccia/dynamics/instruction_set.hpp"

#include "block_layout.hpp"
#include "cell_row_kernel.hpp"
#include "node_rows.hpp"
#include "row_sums.hpp"

namespace breccia::dynamics {

/// A time step of the total-lagrangian formulation, one row at a time. Points never leave their cell, so velocities
/// live on the nodes, the weights are constants and masses are summed once. For every row of cells:
///
///     f = -B^T sigma(B u, history)       find_forces: of the cells on the nodes below and above (theory, Eq. 6, 7, 10)
///
/// and for every row of nodes, as soon as the rows of cells below and above it have given their forces:
///
///     d += dt^2 / m f,  u += d           move_nodes: d is the increment of the displacement (theory, Eq. 11)
///
/// with the boundary condition. The sums of the rows give the averages. In which order rows are taken, and by which
/// thread or process, is for BandSchedule to say.
///
/// Opposite nodes of a periodic box move as one: find_forces adds the forces at the ends of a row crosswise, the lowest
/// row of nodes takes the forces of the highest row of cells too, and images are copies but for the affine motion.
class RowStep {
 public:
  /// For the rows of cells [first_row, end_row). Refers to the problem.
  RowStep(const DynamicProblem<2>& problem, InstructionSet instructions, int first_row, int end_row);

  [[nodiscard]] const DynamicProblem<2>& problem() const noexcept { return *problem_; }
  [[nodiscard]] NodeRows& nodes() noexcept { return nodes_; }
  [[nodiscard]] const NodeRows& nodes() const noexcept { return nodes_; }
  [[nodiscard]] BlockLayout& layout() noexcept { return layout_; }
  [[nodiscard]] const BlockLayout& layout() const noexcept { return layout_; }

  /// Advances the history of a row of cells to the present displacement and finds its forces on the nodes below and
  /// above. Sets the sums of the row at a place; under a traction boundary also those of the highest row of nodes.
  void find_forces(int row, const RowForces& below, const RowForces& above, RowSums& sums, int place);

  /// Moves a row of nodes from a step to the next.
  void move_nodes(int row, const RowForces& from_cells_below, const RowForces& from_cells_above, std::int64_t step);

  /// Makes the highest row of nodes of a periodic box the image of the lowest, after that has been moved from a step.
  void copy_lowest_row(std::int64_t step);

 private:
  void follow_load(int row, std::int64_t step);
  void add_traction(int row, std::int64_t step);
  void close_row(int row, std::int64_t step);
  [[nodiscard]] Strain<2> boundary_strain(int row) const;

  const DynamicProblem<2>* problem_;
  const KernelTable* kernels_;
  BlockLayout layout_;
  NodeRows nodes_;
};

}  // namespace breccia::dynamics

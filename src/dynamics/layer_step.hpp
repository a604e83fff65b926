#pragma once

#include <cstdint>

#include "dynamics/block_layout.hpp"
#include "dynamics/cell_row_kernel.hpp"
#include "dynamics/dynamic_problem.hpp"
#include "dynamics/instruction_set.hpp"
#include "dynamics/layer_sums.hpp"
#include "dynamics/nodal_field.hpp"

namespace breccia::dynamics {

/// A time step of the total-lagrangian formulation, one layer at a time: a row along x in 2 dimensions, a plane across
/// z in 3. Points never leave their cell, so velocities live on the nodes, the weights are constants and masses are
/// summed once. For every layer of cells:
///
///     f = -B^T sigma(B u, history)       find_forces: of the cells on the nodes below and above (theory, Eq. 6, 7, 10
///                                        and 73 to 75)
///
/// and for every layer of nodes, as soon as the layers of cells below and above it have given their forces:
///
///     d += dt^2 / m f,  u += d           move_nodes: d is the increment of the displacement (theory, Eq. 11)
///
/// with the boundary condition. The sums of the layers give the averages. In which order layers are taken, and by which
/// thread or process, is for BandSchedule to say.
///
/// Opposite nodes of a periodic box move as one: find_forces adds the forces on opposite sides of a layer crosswise,
/// the lowest layer of nodes takes the forces of the highest layer of cells too, and images are copies but for the
/// affine motion.
template <int dim>
class LayerStep {
 public:
  /// The step of the layers of cells [first_layer, end_layer). The problem must outlive it.
  LayerStep(const DynamicProblem<dim>& problem, InstructionSet instructions, int first_layer, int end_layer);

  [[nodiscard]] const DynamicProblem<dim>& problem() const noexcept { return *problem_; }
  [[nodiscard]] NodalField<dim>& nodes() noexcept { return nodes_; }
  [[nodiscard]] const NodalField<dim>& nodes() const noexcept { return nodes_; }
  [[nodiscard]] BlockLayout<dim>& layout() noexcept { return layout_; }
  [[nodiscard]] const BlockLayout<dim>& layout() const noexcept { return layout_; }

  /// Advances the history of a layer of cells to the present displacement and finds its forces on the nodes below and
  /// above. Sets the sums of the layer, at the index of the step; under a traction boundary also those of the highest
  /// layer of nodes.
  void find_forces(int layer, const LayerForces<dim>& below, const LayerForces<dim>& above, LayerSums<dim>& sums,
                   int index);

  /// Moves a layer of nodes from a step to the next one.
  void move_nodes(int layer, const LayerForces<dim>& from_cells_below, const LayerForces<dim>& from_cells_above,
                  std::int64_t step);

  /// Makes the highest layer of nodes of a periodic box the image of the lowest one, after the latter has been moved
  /// from a step.
  void copy_lowest_layer(std::int64_t step);

 private:
  using Sums = typename LayerSums<dim>::Sums;

  void find_cell_forces(int layer, const LayerForces<dim>& below, const LayerForces<dim>& above, Sums& sums);
  void find_row_forces(const CellRow<dim>& row) const;
  void join_sides(const LayerForces<dim>& forces) const;
  void integrate(int layer, const LayerForces<dim>& from_cells_below, const LayerForces<dim>& from_cells_above);
  void follow_load(int layer, std::int64_t step);
  void add_traction(int layer, std::int64_t step);
  void close_layer(int layer, std::int64_t step);
  void copy_image(const Index<dim>& from, const Index<dim>& to, int nodes, std::int64_t step);
  [[nodiscard]] Strain<dim> boundary_strain(int layer) const;
  [[nodiscard]] double side_power() const;

  const DynamicProblem<dim>* problem_;
  const KernelTable<dim>* kernels_;
  BlockLayout<dim> layout_;
  NodalField<dim> nodes_;
};

}  // namespace breccia::dynamics

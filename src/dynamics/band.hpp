#pragma once

#include <cstdint>
#include <utility>

#include "dynamics/layer_step.hpp"
#include "dynamics/step_counter.hpp"

namespace breccia::dynamics {

/// Neighbouring layers of cells that one thread takes through a step: first sweep(), then, once the forces of the
/// layers of cells beyond its ends are known, the layers of nodes at its ends.
template <int dim>
class Band {
 public:
  /// Layers of cells [first, end).
  Band(int first, int end, std::size_t nodes_of_layer)
      : first_(first),
        end_(end),
        lowest_(nodes_of_layer),
        bottom_(nodes_of_layer),
        top_(nodes_of_layer),
        carried_(nodes_of_layer),
        highest_(nodes_of_layer) {}

  [[nodiscard]] int first() const noexcept { return first_; }
  [[nodiscard]] int end() const noexcept { return end_; }
  /// Forces of its first layer of cells on the nodes below them, and of its last layer of cells on the nodes above
  /// them.
  [[nodiscard]] LayerForces<dim> lowest_forces() noexcept { return lowest_.view(); }
  [[nodiscard]] LayerForces<dim> highest_forces() noexcept { return highest_.view(); }

  /// Finds the forces of all layers of cells and moves the layers of nodes between them. Calls after_first_layer() when
  /// lowest_forces() are known, and before_last_layer() before it reads the layer of nodes above its last layer of
  /// cells.
  template <class AfterFirstLayer, class BeforeLastLayer>
  void sweep(LayerStep<dim>& layers, LayerSums<dim>& sums, int index, std::int64_t step,
             AfterFirstLayer&& after_first_layer, BeforeLastLayer&& before_last_layer) {
    for (int layer = first_; layer < end_; ++layer) {
      const bool is_first = layer == first_, is_last = layer + 1 == end_;
      if (is_last) before_last_layer();
      const auto below = (is_first ? lowest_ : bottom_).view();
      layers.find_forces(layer, below, (is_last ? highest_ : top_).view(), sums, index);
      if (is_first) after_first_layer();
      if (!is_first) layers.move_nodes(layer, carried_.view(), below, step);
      std::swap(top_, carried_);
    }
  }

  StepCounter swept;  ///< number of steps for which the forces of all of its cells are known
  StepCounter moved;  ///< number of steps in which all of its layers of nodes except the highest have moved

 private:
  int first_, end_;
  ForceLayer<dim> lowest_;   ///< forces of the first layer of cells on the nodes below
  ForceLayer<dim> bottom_;   ///< forces of the present layer of cells on the nodes below
  ForceLayer<dim> top_;      ///< forces of the present layer of cells on the nodes above
  ForceLayer<dim> carried_;  ///< forces of the previous layer of cells on the nodes below the present layer of cells
  ForceLayer<dim> highest_;  ///< forces of the last layer of cells on the nodes above
};

}  // namespace breccia::dynamics

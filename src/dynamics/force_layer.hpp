#pragma once

#include <array>
#include <cstddef>

#include "aligned_vector.hpp"
#include "cell_row_kernel.hpp"

namespace breccia::dynamics {

/// Storage of the forces of a layer of cells on a layer of nodes.
template <int dim>
class ForceLayer {
 public:
  /// All zero, for so many nodes.
  explicit ForceLayer(std::size_t nodes) {
    for (auto& component : values_) component.assign(nodes, 0.0);
  }

  [[nodiscard]] LayerForces<dim> view() noexcept {
    LayerForces<dim> forces;
    for (std::size_t c = 0; c < values_.size(); ++c) forces.of_axis[c] = values_[c].data();
    return forces;
  }

 private:
  std::array<AlignedVector, static_cast<std::size_t>(dim)> values_;
};

}  // namespace breccia::dynamics

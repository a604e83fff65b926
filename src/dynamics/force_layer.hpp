#pragma once

#include <array>
#include <cstddef>

#include "aligned_vector.hpp"
#include "cell_row_kernel.hpp"
#include "cube_row_kernel.hpp"

namespace breccia::dynamics {

/// Storage of the forces of a layer of cells on a layer of nodes.
template <int dim>
class ForceLayer;

template <>
class ForceLayer<2> {
 public:
  static constexpr std::size_t lists = 4;  ///< numbers for each node

  /// All zero, for so many nodes.
  explicit ForceLayer(std::size_t nodes) {
    for (auto& component : values_) component.assign(nodes, 0.0);
  }
  /// For sums of the forces of both cells of a node, which stand in the place of those of the cell to its right. The
  /// others are -0, which changes no bit of a sum, not even the sign of a zero.
  static ForceLayer for_sums(std::size_t nodes) {
    ForceLayer layer(nodes);
    layer.values_[2].assign(nodes, -0.0);
    layer.values_[3].assign(nodes, -0.0);
    return layer;
  }

  [[nodiscard]] LayerForces<2> view() noexcept {
    return {values_[0].data(), values_[1].data(), values_[2].data(), values_[3].data()};
  }

 private:
  std::array<AlignedVector, lists> values_;
};

template <>
class ForceLayer<3> {
 public:
  static constexpr std::size_t lists = 3;

  explicit ForceLayer(std::size_t nodes) {
    for (auto& component : values_) component.assign(nodes, 0.0);
  }
  static ForceLayer for_sums(std::size_t nodes) { return ForceLayer(nodes); }

  [[nodiscard]] LayerForces<3> view() noexcept { return {{values_[0].data(), values_[1].data(), values_[2].data()}}; }

 private:
  std::array<AlignedVector, lists> values_;
};

}  // namespace breccia::dynamics

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/dynamic_solver.hpp"

namespace breccia::dynamics {

/// Contributions of the layers of nodes, and of the layers of cells above them, to the averages of a few steps. Layers
/// are summed in their order once all are known, whichever thread or process found them.
template <int dim>
class LayerSums {
 public:
  struct Sums {
    /// Sum of the stresses of the points of the layer of cells, in Voigt's order [Pa], times the cell side.
    std::array<double, static_cast<std::size_t>(tensor_components<dim>)> stress = {};
    /// The share of the layer of nodes in the integral of sym(u n) over the boundary [m^dim].
    Strain<dim> strain = {};
  };

  explicit LayerSums(const Grid<dim>& grid)
      : steps_(steps_kept(grid)),
        sums_(static_cast<std::size_t>(grid.cells.back() + 1) * static_cast<std::size_t>(steps_)) {}

  /// The number of steps whose sums are kept.
  [[nodiscard]] int steps() const noexcept { return steps_; }
  [[nodiscard]] Sums& of(int layer, int step) noexcept { return sums_[index(layer, step)]; }
  [[nodiscard]] const Sums& of(int layer, int step) const noexcept { return sums_[index(layer, step)]; }

  /// All sums, with the same number of values for each layer of nodes.
  [[nodiscard]] std::span<double> numbers() noexcept {
    constexpr std::size_t numbers_of_layer = 2 * tensor_components<dim>;
    static_assert(sizeof(Sums) == numbers_of_layer * sizeof(double));
    return {sums_.front().stress.data(), numbers_of_layer * sums_.size()};
  }
  [[nodiscard]] std::size_t bytes() const noexcept { return sums_.size() * sizeof(Sums); }

 private:
  /// The number is small, so that the caches are left to the nodes.
  static int steps_kept(const Grid<dim>& grid) {
    constexpr int most_sums = 1 << 10;
    return std::max(1, most_sums / (grid.cells.back() + 1));
  }
  [[nodiscard]] std::size_t index(int layer, int step) const noexcept {
    return static_cast<std::size_t>(layer) * static_cast<std::size_t>(steps_) + static_cast<std::size_t>(step);
  }

  int steps_;
  std::vector<Sums> sums_;
};

/// The averages at a step of the run, which has this index among the steps of the sums. Instantiated for 2 and 3
/// dimensions.
template <int dim>
[[nodiscard]] Averages<dim> averages_of(const DynamicProblem<dim>& problem, const LayerSums<dim>& sums, int index,
                                        std::int64_t step);

}  // namespace breccia::dynamics

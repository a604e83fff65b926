#pragma once

#include <cstddef>
#include <vector>

#include "quasistatic/operator/cell_row.hpp"

namespace breccia::quasistatic {

/// The weight of the displacement of a node of a cubic cell along an axis in the mean volumetric strain of the cell, in
/// units of the cell side: that of a quarter of its face, outwards. Nodes are in the order of CellShape.
[[nodiscard]] constexpr double weight_in_volume(std::size_t node, std::size_t axis) noexcept {
  return ((node >> axis) & 1U) != 0U ? 0.25 : -0.25;
}

/// The mean volumetric strains of a row of cubic cells that follows the first axis, and the forces of their pressures,
/// in units of the cell side.
class CellVolumes {
 public:
  explicit CellVolumes(int cells) : strains_(static_cast<std::size_t>(cells)) {}

  /// The volumetric strains of the cells. Rows of nodes have one node more than there are cells.
  [[nodiscard]] const std::vector<double>& strains(const EdgeRows<const double>& displacement);
  /// Adds the nodal forces of the stresses p of the cells, which do the work p times the volumetric strain.
  void add_forces(const double* stress, const EdgeRows<double>& forces) const;

 private:
  std::vector<double> strains_;
};

}  // namespace breccia::quasistatic

#pragma once

#include <cstddef>
#include <vector>

#include "quasistatic/operator/cell_row.hpp"

namespace breccia::quasistatic {

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

#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace breccia::quasistatic {

/// Nodal values of the four rows of nodes along the edges of a row of cells that follows the first axis, by component.
/// Bit 0 of the number of a row says whether it lies on the upper side along the second axis, bit 1 along the third.
template <class Value>
using EdgeRows = std::array<std::array<Value*, 4>, 3>;

/// Forces of rows of cubic cells with averaged volumetric strains, where each cell has one shear and one bulk modulus.
/// The differences of the nodal displacements of a cell decouple the strains of its points, so that a cell takes some
/// two hundred operations without a stiffness matrix (theory, Eqs. 70 and 71). Lengths are in units of the cell side.
class CellRow {
 public:
  /// `cells` is the number of cells of a row.
  explicit CellRow(int cells);

  /// Adds the nodal forces of the cells under these displacements. `shear` and `bulk` hold the moduli [Pa] by cell.
  /// Rows have one node more than there are cells.
  void add_forces(const EdgeRows<const double>& displacement, const double* shear, const double* bulk,
                  const EdgeRows<double>& forces);

 private:
  static constexpr std::size_t sums_of_node = 12;    ///< four sums and differences of a component over the four rows
  static constexpr std::size_t forces_of_cell = 21;  ///< seven forces on the differences of a component

  void add_up_rows(const EdgeRows<const double>& displacement);
  void find_forces(const double* shear, const double* bulk);
  void distribute(const EdgeRows<double>& forces) const;

  std::size_t cells_;
  std::size_t stride_;          ///< distance between the values of two sums or two forces
  std::vector<double> sums_;    ///< sums by sum and node
  std::vector<double> forces_;  ///< forces by force and cell, with a zero before the first cell and behind the last one
};

}  // namespace breccia::quasistatic

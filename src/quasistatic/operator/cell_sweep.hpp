#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "breccia/microstructure/index.hpp"

#include "discretisation/cell_shape.hpp"
#include "quasistatic/operator/cell_row.hpp"

namespace breccia::quasistatic {

/// The layout of the nodes of a box in arrays that hold one component of a nodal vector each. The first axis is
/// contiguous.
struct NodeArrays {
  Index<3> nodes{};       ///< number of nodes along each axis
  std::size_t row = 0;    ///< distance of nodes that are neighbours along the second axis
  std::size_t plane = 0;  ///< distance of nodes that are neighbours along the third axis

  /// Index of the first node of a row of nodes. In a periodic box the rows behind the last ones are the first ones.
  [[nodiscard]] std::size_t row_at(int second, int third) const noexcept {
    const auto wrapped = [](int index, int count) { return static_cast<std::size_t>(index == count ? 0 : index); };
    return wrapped(second, nodes[1]) * row + wrapped(third, nodes[2]) * plane;
  }
};

/// The kind of each cell of a box, in a larger box whose first axis is contiguous.
struct KindsOfCells {
  const std::uint32_t* first = nullptr;  ///< kind of the first cell
  std::size_t row = 0;                   ///< distance of cells that are neighbours along the second axis
  std::size_t plane = 0;                 ///< distance of cells that are neighbours along the third axis

  /// The kinds of a row of cells.
  [[nodiscard]] const std::uint32_t* row_at(int second, int third) const noexcept {
    return first + static_cast<std::size_t>(second) * row + static_cast<std::size_t>(third) * plane;
  }
  [[nodiscard]] std::uint32_t of(const Index<3>& cell) const noexcept { return row_at(cell[1], cell[2])[cell[0]]; }
};

/// The moduli of the cells of a box, by kind of cell; there are few kinds compared with the number of cells.
struct CellModuli {
  /// A cell whose points are of different materials.
  struct OfManyMaterials {
    Index<3> cell;
    std::uint32_t stiffness;  ///< index of the cell's stiffness
  };

  KindsOfCells kind_of;
  std::vector<double> shear, bulk;  ///< moduli of the kinds of one material or mixture [Pa]; zero for all other kinds
  std::vector<OfManyMaterials> others;                        ///< the other cells, in their order
  std::vector<typename CellShape<3>::Stiffness> stiffnesses;  ///< stiffnesses of the other cells [Pa]
};

/// Forces of all cells of a box of cubic cells, row by row. The rows are divided into slabs that depend on the box
/// alone, so that the results are bitwise identical for any number of threads.
class CellSweep {
 public:
  using Input = std::array<const double*, 3>;  ///< arrays of the components
  using Output = std::array<double*, 3>;       ///< arrays of the components

  /// The lowest node of the first cell is the first node of the arrays. Rows of nodes have one node more than there are
  /// cells. Along the other axes the nodes behind the last cells may be missing in a periodic box, where they are the
  /// first nodes.
  CellSweep(const Index<3>& cells, const NodeArrays& nodes) : cells_(cells), nodes_(nodes) {}

  /// Adds the nodal forces of the cells.
  void add_forces(const CellModuli& moduli, const Input& displacement, const Output& forces, int threads) const;

  /// Calls work(thread, first plane, plane behind the last one) for slabs of planes of cells: two slabs that share
  /// nodes are never taken at the same time, and always in the same order.
  void for_slabs(int threads, const std::function<void(int, int, int)>& work) const;

 private:
  /// Planes of cells of a slab, which one thread takes at a time.
  static constexpr int planes_of_slab = 4;

  /// The arrays of a thread for a row of cells.
  struct Row {
    explicit Row(int cells)
        : forces(cells), shear(static_cast<std::size_t>(cells)), bulk(static_cast<std::size_t>(cells)) {}

    CellRow forces;
    std::vector<double> shear, bulk;  ///< moduli by cell [Pa]
  };

  void add_slab(const CellModuli& moduli, int first_plane, int end_plane, const Input& displacement,
                const Output& forces, Row& row) const;
  void add_others(const CellModuli& moduli, int first_plane, int end_plane, const Input& displacement,
                  const Output& forces) const;
  [[nodiscard]] std::size_t index_of(const Index<3>& cell, int node) const noexcept;

  Index<3> cells_;
  NodeArrays nodes_;
};

}  // namespace breccia::quasistatic

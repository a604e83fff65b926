#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/grid.hpp"
#include "breccia/microstructure/microstructure.hpp"

#include "discretisation/gaps/gap_cell.hpp"

namespace breccia::gaps {

/// The cells of a grid that have gaps, and the unknowns of their faces.
class GapCells {
 public:
  /// `places` are the places of the cells in the grid, `nodes` the nodes at which faces begin; `first_unknowns` say
  /// where the unknowns of the faces begin, by node and axis, and last how many there are.
  GapCells(const Grid<2>& grid, std::vector<GapCell> cells, std::span<const std::size_t> places,
           const IndexRange<2>& nodes, std::vector<std::int32_t> first_unknowns);

  /// The gap cell at a cell of the grid; null for other cells.
  [[nodiscard]] const GapCell* at(const Index<2>& cell) const noexcept {
    const auto number = numbers_[grid_.cell_index(cell)];
    return number < 0 ? nullptr : &cells_[static_cast<std::size_t>(number)];
  }
  [[nodiscard]] std::span<const GapCell> cells() const noexcept { return cells_; }
  /// Number of the unknowns of all faces.
  [[nodiscard]] std::int32_t unknowns() const noexcept { return first_unknowns_.back(); }
  /// The range of the numbers of the unknowns of the two faces that begin at a node. A node at the end of a periodic
  /// box is that at its beginning.
  [[nodiscard]] std::array<std::int32_t, 2> unknowns_at(const Index<2>& node) const noexcept {
    return {unknowns_at(node, 0)[0], unknowns_at(node, 1)[1]};
  }
  /// The range of those of the face that begins at a node and goes along an axis.
  [[nodiscard]] std::array<std::int32_t, 2> unknowns_at(const Index<2>& node, std::size_t axis) const noexcept {
    const auto [columns, rows] = nodes_.end;
    const auto face = 2 * nodes_.place_of({node[0] % columns, node[1] % rows}) + axis;
    return {first_unknowns_[face], first_unknowns_[face + 1]};
  }

 private:
  Grid<2> grid_;
  std::vector<GapCell> cells_;
  std::vector<std::int32_t> numbers_;
  IndexRange<2> nodes_;
  std::vector<std::int32_t> first_unknowns_;
};

/// The gap cells of particles in a box, on `cells` cells along each axis, under a boundary; gaps are those between
/// coatings, and between coatings and sides under a displacement boundary. Throws InputError for particles that
/// overlap, and unless the boundary is periodic for a periodic box and for no other.
[[nodiscard]] GapCells find_gap_cells(const ParticlesInBox& particles, int cells, Boundary boundary);

}  // namespace breccia::gaps

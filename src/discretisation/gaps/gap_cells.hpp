#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/grid.hpp"
#include "breccia/microstructure/microstructure.hpp"

#include "discretisation/gaps/gap_cell.hpp"

namespace breccia::gaps {

/// The cells of a grid that have gaps, and the unknowns of their faces.
class GapCells {
 public:
  /// `places` are the places of the cells in the grid; `first_unknowns` say where the unknowns of the faces begin, by
  /// node and axis, and last how many there are.
  GapCells(const Grid<2>& grid, std::vector<GapCell> cells, std::span<const std::size_t> places,
           std::vector<std::int32_t> first_unknowns);

  /// The gap cell at a cell of the grid; null for other cells.
  [[nodiscard]] const GapCell* at(const Index<2>& cell) const noexcept {
    const auto number = numbers_[grid_.cell_index(cell)];
    return number < 0 ? nullptr : &cells_[static_cast<std::size_t>(number)];
  }
  [[nodiscard]] std::span<const GapCell> cells() const noexcept { return cells_; }
  /// The phases in the cells, in the order of their numbers.
  [[nodiscard]] std::span<const PhaseIndex> phases() const noexcept { return phases_; }
  /// Number of the unknowns of all faces.
  [[nodiscard]] std::int32_t unknowns() const noexcept { return first_unknowns_.back(); }
  /// The range of the numbers of the unknowns of the two faces that begin at a node.
  [[nodiscard]] std::array<std::int32_t, 2> unknowns_at(const Index<2>& node) const noexcept {
    return {unknowns_at(node, 0)[0], unknowns_at(node, 1)[1]};
  }
  /// The range of those of the face that begins at a node and goes along an axis.
  [[nodiscard]] std::array<std::int32_t, 2> unknowns_at(const Index<2>& node, std::size_t axis) const noexcept {
    const auto face = 2 * grid_.cell_index(node) + axis;
    return {first_unknowns_[face], first_unknowns_[face + 1]};
  }

 private:
  Grid<2> grid_;
  std::vector<GapCell> cells_;
  std::vector<std::int32_t> numbers_;
  std::vector<PhaseIndex> phases_;
  std::vector<std::int32_t> first_unknowns_;
};

/// The gap cells of discs in a periodic box, on `cells` cells along each axis. `particles` holds the phases of each
/// disc; gaps are those between coatings. Throws InputError for another box.
[[nodiscard]] GapCells find_gap_cells(const Microstructure<2>& microstructure, int cells, PhaseIndex matrix,
                                      std::span<const ParticlePhases> particles);

}  // namespace breccia::gaps

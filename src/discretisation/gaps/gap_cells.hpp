#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "breccia/discretisation/grid.hpp"
#include "breccia/microstructure/index.hpp"

#include "discretisation/gaps/gap_cell.hpp"

namespace breccia::gaps {

/// The cells of a grid that have gaps, and the unknowns of their gaps. An unknown belongs to a node: a flow to the
/// lowest node of its face.
template <int dim>
class GapCells {
 public:
  /// In the plane the unknowns of a node are those of two faces, which begin at it.
  static constexpr std::size_t groups_of_node = dim == 2 ? 2 : 1;

  /// `places` are the places of the cells in the grid, `nodes` the nodes to which unknowns belong; `first_unknowns` say
  /// where the numbers of the unknowns begin, by node and group, and last how many there are.
  GapCells(const Grid<dim>& grid, std::vector<GapCell<dim>> cells, std::span<const std::size_t> places,
           const IndexRange<dim>& nodes, std::vector<std::int32_t> first_unknowns);

  /// The gap cell at a cell of the grid; null for other cells.
  [[nodiscard]] const GapCell<dim>* at(const Index<dim>& cell) const noexcept {
    const auto number = numbers_[grid_.cell_index(cell)];
    return number < 0 ? nullptr : &cells_[static_cast<std::size_t>(number)];
  }
  [[nodiscard]] std::span<const GapCell<dim>> cells() const noexcept { return cells_; }
  /// Number of the unknowns of all gaps.
  [[nodiscard]] std::int32_t unknowns() const noexcept { return first_unknowns_.back(); }
  /// The range of the numbers of the unknowns that belong to a node. A node at the end of a periodic box is that at its
  /// beginning.
  [[nodiscard]] std::array<std::int32_t, 2> unknowns_at(const Index<dim>& node) const noexcept {
    const auto first = groups_of_node * place_of(node);
    return {first_unknowns_[first], first_unknowns_[first + groups_of_node]};
  }
  /// The range of those of the face that begins at a node and goes along an axis.
  [[nodiscard]] std::array<std::int32_t, 2> unknowns_at(const Index<dim>& node, std::size_t axis) const noexcept
      requires(dim == 2) {
    const auto face = groups_of_node * place_of(node) + axis;
    return {first_unknowns_[face], first_unknowns_[face + 1]};
  }

 private:
  [[nodiscard]] std::size_t place_of(Index<dim> node) const noexcept {
    for (std::size_t axis = 0; axis < node.size(); ++axis) node[axis] %= nodes_.end[axis];
    return nodes_.place_of(node);
  }

  Grid<dim> grid_;
  std::vector<GapCell<dim>> cells_;
  std::vector<std::int32_t> numbers_;
  IndexRange<dim> nodes_;
  std::vector<std::int32_t> first_unknowns_;
};

/// The gap cells of a grid; make(cell) returns that at a cell of the grid, or nothing. The other arguments are those of
/// GapCells.
template <int dim, class Make>
[[nodiscard]] GapCells<dim> collect_gap_cells(const Grid<dim>& grid, const IndexRange<dim>& nodes,
                                              std::vector<std::int32_t> first_unknowns, const Make& make) {
  std::vector<GapCell<dim>> cells;
  std::vector<std::size_t> places;
  grid.for_each_cell([&](const Index<dim>& at) {
    auto cell = make(at);
    if (!cell) return;
    cells.push_back(std::move(*cell));
    places.push_back(grid.cell_index(at));
  });
  return {grid, std::move(cells), places, nodes, std::move(first_unknowns)};
}

extern template class GapCells<2>;
extern template class GapCells<3>;

}  // namespace breccia::gaps

#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// Square cells that fill the box [0, columns * cell_side] x [0, rows * cell_side].
struct Grid {
  int columns = 0;
  int rows = 0;
  double cell_side = 0.0;  ///< h [m]

  [[nodiscard]] std::size_t cells() const noexcept {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
  [[nodiscard]] std::size_t nodes() const noexcept {
    return (static_cast<std::size_t>(columns) + 1) * (static_cast<std::size_t>(rows) + 1);
  }
  /// Indices in lists that hold cells or nodes row by row, from the lower left corner.
  [[nodiscard]] std::size_t cell_index(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] std::size_t node_index(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * (static_cast<std::size_t>(columns) + 1) + static_cast<std::size_t>(column);
  }
  /// Index of a point in lists that hold the rows of the lattice of points, two to a row of cells.
  [[nodiscard]] std::size_t point_index(int column, int row, int point) const noexcept {
    const auto lattice_row = 2 * static_cast<std::size_t>(row) + static_cast<std::size_t>(point / 2);
    const auto lattice_column = 2 * static_cast<std::size_t>(column) + static_cast<std::size_t>(point % 2);
    return lattice_row * 2 * static_cast<std::size_t>(columns) + lattice_column;
  }
  [[nodiscard]] double area() const noexcept { return static_cast<double>(cells()) * cell_side * cell_side; }

  friend bool operator==(const Grid&, const Grid&) = default;
};

/// Index of a material in the list that goes with a discretisation.
using MaterialIndex = std::uint8_t;

/// In the place of a material: there is no point here.
constexpr MaterialIndex no_material = 255;

/// Four material points in a cell, at +-h/4 from its centre, each with a quarter of its area.
constexpr int points_per_cell = 4;

/// Positions of the points relative to the cell centre in units of h; the order of points throughout:
/// lower left, lower right, upper left, upper right. Nodes of a cell come in the same order.
constexpr std::array<Vector<2>, points_per_cell> point_offsets = {
    {{-0.25, -0.25}, {0.25, -0.25}, {-0.25, 0.25}, {0.25, 0.25}}};

/// The materials of the four points of one cell.
using CellMaterials = std::array<MaterialIndex, points_per_cell>;

/// A microstructure seen by a grid: the material of every point.
class Discretisation {
 public:
  /// All points of one material. Throws InputError when the grid has no cells or no size.
  explicit Discretisation(const Grid& grid, MaterialIndex matrix = 0);

  [[nodiscard]] const Grid& grid() const noexcept { return grid_; }
  [[nodiscard]] std::size_t points() const noexcept { return cells_.size() * points_per_cell; }

  [[nodiscard]] const CellMaterials& cell(int column, int row) const noexcept {
    return cells_[grid_.cell_index(column, row)];
  }
  [[nodiscard]] const std::vector<CellMaterials>& cells() const noexcept { return cells_; }

  /// Position of a point of a cell [m].
  [[nodiscard]] Vector<2> position(int column, int row, int point) const noexcept;

  /// Gives a material to all points for which inside(position [m]) holds.
  template <std::predicate<const Vector<2>&> Inside>
  void paint(Inside&& inside, MaterialIndex material) {
    paint_range({0, grid_.columns}, {0, grid_.rows}, inside, material);
  }

  /// Gives a material to all points in a disc.
  void paint(const Disc& disc, MaterialIndex material);

  /// Share of the points that have each of the materials 0 .. count - 1.
  [[nodiscard]] std::vector<double> fractions(std::size_t count) const;

 private:
  struct Range {
    int begin;
    int end;
  };

  template <class Inside>
  void paint_range(Range columns, Range rows, Inside&& inside, MaterialIndex material) {
    for (int row = rows.begin; row < rows.end; ++row) {
      for (int column = columns.begin; column < columns.end; ++column) {
        auto& cell = cells_[grid_.cell_index(column, row)];
        for (std::size_t p = 0; p < points_per_cell; ++p) {
          if (inside(position(column, row, static_cast<int>(p)))) cell[p] = material;
        }
      }
    }
  }

  Grid grid_;
  std::vector<CellMaterials> cells_;
};

/// The points of a microstructure on cells x cells cells: matrix everywhere, filler in the discs and, for a periodic
/// box, in their images.
Discretisation discretise(const Microstructure& microstructure, int cells, MaterialIndex matrix = 0,
                          MaterialIndex filler = 1);

}  // namespace breccia

#include "breccia/discretisation/discretisation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

Discretisation::Discretisation(const Grid& grid, MaterialIndex matrix) : grid_(grid) {
  if (grid.columns < 1 || grid.rows < 1 || !(grid.cell_side > 0.0)) {
    throw InputError(
        fmt::format("discretisation: expected at least one cell of positive side, got {} x {} cells of {} m",
                    grid.columns, grid.rows, grid.cell_side));
  }
  cells_.assign(grid.cells(), {matrix, matrix, matrix, matrix});
}

Vector<2> Discretisation::position(int column, int row, int point) const noexcept {
  const auto& offset = point_offsets[static_cast<std::size_t>(point)];
  return {(column + 0.5 + offset[0]) * grid_.cell_side, (row + 0.5 + offset[1]) * grid_.cell_side};
}

void Discretisation::paint(const Disc& disc, MaterialIndex material) {
  const auto cells_touched = [&](double centre, int count) -> Range {
    const double first = std::floor((centre - 0.5 * disc.diameter) / grid_.cell_side);
    const double last = std::floor((centre + 0.5 * disc.diameter) / grid_.cell_side);
    return {static_cast<int>(std::clamp(first, 0.0, static_cast<double>(count))),
            static_cast<int>(std::clamp(last + 1.0, 0.0, static_cast<double>(count)))};
  };
  paint_range(
      cells_touched(disc.centre[0], grid_.columns), cells_touched(disc.centre[1], grid_.rows),
      [&](const Vector<2>& point) { return disc.contains(point); }, material);
}

std::vector<double> Discretisation::fractions(std::size_t count) const {
  std::vector<double> fractions(count, 0.0);
  for (const auto& cell : cells_) {
    for (const auto material : cell) {
      if (material != no_material) fractions.at(material) += 1.0;
    }
  }
  for (auto& fraction : fractions) fraction /= static_cast<double>(points());
  return fractions;
}

Discretisation discretise(const Microstructure& microstructure, int cells, MaterialIndex matrix, MaterialIndex filler) {
  Discretisation discretisation({cells, cells, microstructure.side / cells}, matrix);
  const int images = microstructure.walls == Walls::periodic ? 1 : 0;
  for (const auto& disc : microstructure.discs) {
    for (int i = -images; i <= images; ++i) {
      for (int j = -images; j <= images; ++j) {
        discretisation.paint(
            Disc{{disc.centre[0] + i * microstructure.side, disc.centre[1] + j * microstructure.side}, disc.diameter},
            filler);
      }
    }
  }
  return discretisation;
}

}  // namespace breccia

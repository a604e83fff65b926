#include "breccia/discretisation/image_cells.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "mixture_numbers.hpp"

namespace breccia {
namespace {

void require_phases_of_labels(const LabelImage<2>& image, std::span<const PhaseIndex> phases) {
  require_valid(image);
  const auto largest = std::ranges::max(image.labels);
  if (largest < phases.size()) return;
  throw InputError(fmt::format("discretisation: a pixel has the label {}, counted from 0, but there are only {} labels",
                               largest, phases.size()));
}

std::size_t place_of(const LabelImage<2>& image, std::int64_t column, std::int64_t row) {
  return static_cast<std::size_t>(row * image.pixels[0] + column);
}

/// The pixel along one axis that each point of a grid is in. There are two points to a cell, in the middle of its
/// halves.
std::vector<std::int64_t> pixels_of_points(std::int64_t cells, std::int64_t pixels) {
  std::vector<std::int64_t> of_points;
  for (std::int64_t half = 0; half < 2 * cells; ++half) of_points.push_back((2 * half + 1) * pixels / (4 * cells));
  return of_points;
}

/// The part of a row of pixels that is in one cell.
struct PixelShare {
  std::int64_t pixel;
  std::int64_t length;  ///< in units of which a pixel has as many as there are cells, and a cell as many as pixels
};

/// The pixels that each cell along one axis reaches over.
std::vector<std::vector<PixelShare>> pixels_of_cells(std::int64_t cells, std::int64_t pixels) {
  std::vector<std::vector<PixelShare>> of_cells;
  for (std::int64_t cell = 0; cell < cells; ++cell) {
    auto& shares = of_cells.emplace_back();
    const auto begin = cell * pixels, end = begin + pixels;
    for (auto pixel = begin / cells; pixel * cells < end; ++pixel) {
      shares.push_back({pixel, std::min(end, (pixel + 1) * cells) - std::max(begin, pixel * cells)});
    }
  }
  return of_cells;
}

}  // namespace

Discretisation<2> discretise(const Grid<2>& grid, const LabelImage<2>& image, std::span<const PhaseIndex> phases) {
  require_phases_of_labels(image, phases);
  Discretisation<2> discretisation(grid);
  const std::array pixels = {pixels_of_points(grid.cells[0], image.pixels[0]),
                             pixels_of_points(grid.cells[1], image.pixels[1])};
  const double spacing = 0.5 * grid.cell_side;
  discretisation.label([&](const Vector<2>& position) {
    // Points are in the middle of halves of cells, far from where rounding would matter.
    const auto pixel_along = [&](std::size_t axis) {
      return pixels[axis][static_cast<std::size_t>(position[axis] / spacing)];
    };
    return phases[image.labels[place_of(image, pixel_along(0), pixel_along(1))]];
  });
  return discretisation;
}

Discretisation<2> discretise_mixed(const Grid<2>& grid, const LabelImage<2>& image, std::span<const PhaseIndex> phases,
                                   std::size_t phase_count) {
  require_phases_of_labels(image, phases);
  if (std::ranges::any_of(phases, [&](PhaseIndex phase) { return phase >= phase_count; })) {
    throw InputError(fmt::format("discretisation: a label has a phase beyond the {} that there are", phase_count));
  }
  Discretisation<2> discretisation(grid);
  MixtureNumbers numbers(discretisation, phase_count);
  const auto columns = pixels_of_cells(grid.cells[0], image.pixels[0]);
  const auto rows = pixels_of_cells(grid.cells[1], image.pixels[1]);
  std::vector<std::int64_t> areas(phase_count);
  grid.for_each_cell([&](const Index<2>& cell) {
    std::ranges::fill(areas, 0);
    for (const auto& [row, height] : rows[static_cast<std::size_t>(cell[1])]) {
      for (const auto& [column, width] : columns[static_cast<std::size_t>(cell[0])]) {
        areas[phases[image.labels[place_of(image, column, row)]]] += width * height;
      }
    }
    numbers.fill(cell, rounded_content(areas));
  });
  return discretisation;
}

}  // namespace breccia

#include "discretisation/image_cells.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/mixture_numbers.hpp"

namespace breccia {
namespace {

template <int dim>
void require_phases_of_labels(const LabelImage<dim>& image, std::span<const PhaseIndex> phases) {
  require_valid(image);
  const auto largest = std::ranges::max(image.labels);
  if (largest < phases.size()) return;
  throw InputError(fmt::format("discretisation: a pixel has the label {}, counted from 0, but there are only {} labels",
                               largest, phases.size()));
}

/// The indices of a pixel along every axis.
template <int dim>
using Pixel = std::array<std::int64_t, static_cast<std::size_t>(dim)>;

template <int dim>
Label label_of(const LabelImage<dim>& image, const Pixel<dim>& pixel) {
  std::int64_t index = 0;
  for (std::size_t axis = pixel.size(); axis-- > 0;) index = index * image.pixels[axis] + pixel[axis];
  return image.labels[static_cast<std::size_t>(index)];
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
  std::int64_t length;  ///< length in a common unit: a pixel is `cells` units long, and a cell `pixels`
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

/// The pixels that a cell reaches over, along each axis.
template <int dim>
using PixelsOfCell = std::array<std::span<const PixelShare>, static_cast<std::size_t>(dim)>;

/// Adds the volumes of the pixels that a cell reaches over to those of their phases.
template <int dim>
void add_volumes(const LabelImage<dim>& image, std::span<const PhaseIndex> phases, const PixelsOfCell<dim>& along,
                 std::vector<std::int64_t>& volumes) {
  Index<dim> counts{};
  for (std::size_t axis = 0; axis < counts.size(); ++axis) counts[axis] = static_cast<int>(along[axis].size());
  for_each_index(Index<dim>{}, counts, [&](const Index<dim>& index) {
    Pixel<dim> pixel{};
    std::int64_t volume = 1;
    for (std::size_t axis = 0; axis < pixel.size(); ++axis) {
      const auto& share = along[axis][static_cast<std::size_t>(index[axis])];
      pixel[axis] = share.pixel;
      volume *= share.length;
    }
    volumes[phases[label_of(image, pixel)]] += volume;
  });
}

}  // namespace

template <int dim>
Discretisation<dim> discretise(const Grid<dim>& grid, const LabelImage<dim>& image, std::span<const PhaseIndex> phases,
                               const CellLayers& layers) {
  require_phases_of_labels(image, phases);
  Discretisation<dim> discretisation(grid, 0, layers);
  std::array<std::vector<std::int64_t>, static_cast<std::size_t>(dim)> pixels;
  for (std::size_t axis = 0; axis < pixels.size(); ++axis) {
    pixels[axis] = pixels_of_points(grid.cells[axis], image.pixels[axis]);
  }
  const double spacing = 0.5 * grid.cell_side;
  discretisation.label([&](const Vector<dim>& position) {
    // Points are in the middle of halves of cells, far from where rounding would matter.
    Pixel<dim> pixel{};
    for (std::size_t axis = 0; axis < pixel.size(); ++axis) {
      pixel[axis] = pixels[axis][static_cast<std::size_t>(position[axis] / spacing)];
    }
    return phases[label_of(image, pixel)];
  });
  return discretisation;
}

template <int dim>
Discretisation<dim> discretise_mixed(const Grid<dim>& grid, const LabelImage<dim>& image,
                                     std::span<const PhaseIndex> phases, std::size_t phase_count,
                                     const CellLayers& layers) {
  require_phases_of_labels(image, phases);
  if (std::ranges::any_of(phases, [&](PhaseIndex phase) { return phase >= phase_count; })) {
    throw InputError(fmt::format("discretisation: a label has a phase beyond the {} that there are", phase_count));
  }
  Discretisation<dim> discretisation(grid, 0, layers);
  MixtureNumbers<dim> numbers(discretisation, phase_count);
  std::array<std::vector<std::vector<PixelShare>>, static_cast<std::size_t>(dim)> pixels;
  for (std::size_t axis = 0; axis < pixels.size(); ++axis) {
    pixels[axis] = pixels_of_cells(grid.cells[axis], image.pixels[axis]);
  }
  std::vector<std::int64_t> volumes(phase_count);
  const auto& [begin, end] = discretisation.range();
  for_each_index(begin, end, [&](const Index<dim>& cell) {
    PixelsOfCell<dim> along;
    for (std::size_t axis = 0; axis < along.size(); ++axis) {
      along[axis] = pixels[axis][static_cast<std::size_t>(cell[axis])];
    }
    std::ranges::fill(volumes, 0);
    add_volumes<dim>(image, phases, along, volumes);
    numbers.fill(cell, rounded_content(volumes));
  });
  return discretisation;
}

template Discretisation<2> discretise(const Grid<2>&, const LabelImage<2>&, std::span<const PhaseIndex>,
                                      const CellLayers&);
template Discretisation<3> discretise(const Grid<3>&, const LabelImage<3>&, std::span<const PhaseIndex>,
                                      const CellLayers&);
template Discretisation<2> discretise_mixed(const Grid<2>&, const LabelImage<2>&, std::span<const PhaseIndex>,
                                            std::size_t, const CellLayers&);
template Discretisation<3> discretise_mixed(const Grid<3>&, const LabelImage<3>&, std::span<const PhaseIndex>,
                                            std::size_t, const CellLayers&);

}  // namespace breccia

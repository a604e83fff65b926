#include "breccia/discretisation/mixed_cells.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/disc_overlap.hpp"

#include "mixture_numbers.hpp"

namespace breccia {
namespace {

/// An area in units of that of a cell as the nearest number of steps.
int to_steps(double area) {
  return static_cast<int>(std::lround(mixture_steps * area));
}

/// A share of a cell that a disc covers in part.
struct Cover {
  std::size_t cell;
  PhaseIndex phase;
  double area;  ///< in units of the area of the cell
};

/// Fills the cells that a disc covers, and lists those that it covers in part.
void cover(const Disc& disc, PhaseIndex phase, Discretisation<2>& discretisation, std::vector<Cover>& covers) {
  const auto& grid = discretisation.grid();
  constexpr double rounding = 1e-9;
  const double h = grid.cell_side, radius = 0.5 * disc.diameter;
  Index<2> begin{}, end{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto cell_of = [&](double x) {
      return static_cast<int>(std::clamp(std::floor(x / h), 0.0, static_cast<double>(grid.cells[axis])));
    };
    begin[axis] = cell_of(disc.centre[axis] - radius);
    end[axis] = std::min(cell_of(disc.centre[axis] + radius) + 1, grid.cells[axis]);
  }
  for_each_index(begin, end, [&](const Index<2>& cell) {
    const Vector<2> lower = {cell[0] * h, cell[1] * h}, upper = {(cell[0] + 1) * h, (cell[1] + 1) * h};
    const double area = overlap_area(disc, lower, upper) / (h * h);
    if (area >= 1.0 - rounding) {
      discretisation.fill(cell, phase);
    } else if (area > rounding) {
      covers.push_back({grid.cell_index(cell), phase, area});
    }
  });
}

/// The content of a cell with these covers, which are sorted by phase.
CellContent content_of(std::span<const Cover> covers, PhaseIndex matrix) {
  CellContent content = {{matrix, mixture_steps}};
  for (auto first = covers.begin(); first != covers.end();) {
    const auto phase = first->phase;
    double area = 0.0;
    for (; first != covers.end() && first->phase == phase; ++first) area += first->area;
    const int steps = std::min(to_steps(area), content.front().second);
    if (steps == 0) continue;
    content.front().second -= steps;
    content.emplace_back(phase, steps);
  }
  if (content.front().second == 0) content.erase(content.begin());
  return content;
}

}  // namespace

Discretisation<2> discretise_mixed(const Microstructure<2>& microstructure, int cells, PhaseIndex matrix,
                                   std::span<const PhaseIndex> particles, std::size_t phases) {
  if (particles.size() != microstructure.particles.size()) {
    throw InputError(fmt::format("discretisation: expected a phase for each of {} particles, got {}",
                                 microstructure.particles.size(), particles.size()));
  }
  const auto largest = particles.empty() ? matrix : std::max(matrix, std::ranges::max(particles));
  if (largest >= phases) {
    throw InputError(fmt::format("discretisation: a phase has the number {}, counted from 0, but there are only {}",
                                 largest, phases));
  }
  Discretisation<2> discretisation({{cells, cells}, microstructure.side / cells}, matrix);
  std::vector<Cover> covers;
  for_each_image(microstructure, [&](std::size_t particle, const Disc& disc) {
    cover(disc, particles[particle], discretisation, covers);
  });
  std::ranges::sort(covers, {}, [](const Cover& one) { return std::tuple(one.cell, one.phase, one.area); });
  MixtureNumbers numbers(discretisation, phases);
  for (auto first = covers.begin(); first != covers.end();) {
    const auto cell = first->cell;
    const auto end = std::find_if(first, covers.end(), [&](const Cover& one) { return one.cell != cell; });
    const auto place = discretisation.grid().cell_at(cell);
    // A cell that one disc fills stays so where another overlaps it.
    const bool is_filled = discretisation.cell(place).front() != matrix;
    if (!is_filled) numbers.fill(place, content_of({first, end}, matrix));
    first = end;
  }
  return discretisation;
}

std::vector<Material> with_mixtures(const Discretisation<2>& discretisation, std::vector<Material> materials) {
  const auto phases = materials.size();
  for (const auto& mixture : discretisation.mixtures()) {
    materials.push_back(series_material(mixture, std::span(materials).first(phases)));
  }
  return materials;
}

}  // namespace breccia

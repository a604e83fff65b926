#include "breccia/discretisation/mixed_cells.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
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

/// A share of a cell that a phase of a particle covers in part.
struct Cover {
  std::size_t cell;
  PhaseIndex phase;
  double area;  ///< in units of the area of the cell
};

/// A disc without what is inside a smaller disc around the same centre: a particle, or its coating.
struct Annulus {
  Disc outer;
  double inner_diameter;  ///< [m]; 0 for the whole disc
  PhaseIndex phase;
};

/// Area that an annulus and a cell have in common, in units of the area of the cell, exact to rounding.
double covered_share(const Annulus& annulus, const Vector<2>& lower, const Vector<2>& upper, double h) {
  const double whole = overlap_area(annulus.outer, lower, upper) / (h * h);
  if (annulus.inner_diameter == 0.0 || whole == 0.0) return whole;
  return whole - overlap_area({annulus.outer.centre, annulus.inner_diameter}, lower, upper) / (h * h);
}

/// Fills the cells that an annulus covers, and lists those that it covers in part.
void cover(const Annulus& annulus, Discretisation<2>& discretisation, std::vector<Cover>& covers) {
  const auto& grid = discretisation.grid();
  constexpr double rounding = 1e-9;
  const double h = grid.cell_side, radius = 0.5 * annulus.outer.diameter;
  Index<2> begin{}, end{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto cell_of = [&](double x) {
      return static_cast<int>(std::clamp(std::floor(x / h), 0.0, static_cast<double>(grid.cells[axis])));
    };
    begin[axis] = cell_of(annulus.outer.centre[axis] - radius);
    end[axis] = std::min(cell_of(annulus.outer.centre[axis] + radius) + 1, grid.cells[axis]);
  }
  for_each_index(begin, end, [&](const Index<2>& cell) {
    const Vector<2> lower = {cell[0] * h, cell[1] * h}, upper = {(cell[0] + 1) * h, (cell[1] + 1) * h};
    const double area = covered_share(annulus, lower, upper, h);
    if (area >= 1.0 - rounding) {
      discretisation.fill(cell, annulus.phase);
    } else if (area > rounding) {
      covers.push_back({grid.cell_index(cell), annulus.phase, area});
    }
  });
}

/// The content of a cell with these covers, which are sorted by phase. Where they fill the cell, what rounding leaves
/// to the matrix belongs to the largest of them.
CellContent content_of(std::span<const Cover> covers, PhaseIndex matrix) {
  constexpr double rounding = 1e-9;
  CellContent content = {{matrix, mixture_steps}};
  double all = 0.0;
  for (auto first = covers.begin(); first != covers.end();) {
    const auto phase = first->phase;
    double area = 0.0;
    for (; first != covers.end() && first->phase == phase; ++first) area += first->area;
    all += area;
    const int steps = std::min(to_steps(area), content.front().second);
    if (steps == 0) continue;
    content.front().second -= steps;
    content.emplace_back(phase, steps);
  }
  if (all >= 1.0 - rounding && content.size() > 1) {
    const auto largest = std::max_element(content.begin() + 1, content.end(),
                                          [](const auto& one, const auto& other) { return one.second < other.second; });
    largest->second += std::exchange(content.front().second, 0);
  }
  if (content.front().second == 0) content.erase(content.begin());
  return content;
}

/// Throws InputError where a number is that of no phase.
void require_known(PhaseIndex matrix, std::span<const ParticlePhases> particles, std::size_t phases) {
  auto largest = matrix;
  for (const auto& [phase, coating, thickness] : particles) {
    largest = std::max({largest, phase, thickness > 0.0 ? coating : phase});
  }
  if (largest < phases) return;
  throw InputError(
      fmt::format("discretisation: a phase has the number {}, counted from 0, but there are only {}", largest, phases));
}

}  // namespace

Discretisation<2> discretise_mixed(const Microstructure<2>& microstructure, int cells, PhaseIndex matrix,
                                   std::span<const ParticlePhases> particles, std::size_t phases) {
  if (particles.size() != microstructure.particles.size()) {
    throw InputError(fmt::format("discretisation: expected a phase for each of {} particles, got {}",
                                 microstructure.particles.size(), particles.size()));
  }
  require_known(matrix, particles, phases);
  Discretisation<2> discretisation({{cells, cells}, microstructure.side / cells}, matrix);
  std::vector<Cover> covers;
  for_each_image(microstructure, [&](std::size_t particle, const Disc& disc) {
    const auto& [phase, coating, thickness] = particles[particle];
    cover({disc, 0.0, phase}, discretisation, covers);
    if (thickness > 0.0) {
      cover({{disc.centre, disc.diameter + 2.0 * thickness}, disc.diameter, coating}, discretisation, covers);
    }
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

Discretisation<2> discretise_mixed(const Microstructure<2>& microstructure, int cells, PhaseIndex matrix,
                                   std::span<const PhaseIndex> particles, std::size_t phases) {
  return discretise_mixed(microstructure, cells, matrix, without_coatings(particles), phases);
}

std::vector<Material> with_mixtures(const Discretisation<2>& discretisation, std::vector<Material> materials) {
  const auto phases = materials.size();
  for (const auto& mixture : discretisation.mixtures()) {
    materials.push_back(series_material(mixture, std::span(materials).first(phases)));
  }
  return materials;
}

}  // namespace breccia

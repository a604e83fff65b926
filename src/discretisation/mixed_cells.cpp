#include "discretisation/mixed_cells.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/mixture_numbers.hpp"
#include "discretisation/mixture_rule.hpp"
#include "microstructure/disc_overlap.hpp"
#include "microstructure/sphere_overlap.hpp"

namespace breccia {
namespace {

/// A share of a cell as the nearest number of steps.
int to_steps(double share) {
  return static_cast<int>(std::lround(mixture_steps * share));
}

/// Area or volume that a ball and the box between two corners have in common [m^dim].
double overlap(const Disc& disc, const Vector<2>& lower, const Vector<2>& upper) {
  return overlap_area(disc, lower, upper);
}
double overlap(const Sphere& sphere, const Vector<3>& lower, const Vector<3>& upper) {
  return overlap_volume(sphere, lower, upper);
}

/// A share of a cell that a phase of a particle covers in part.
struct Cover {
  std::size_t cell;
  PhaseIndex phase;
  double share;  ///< share of the area or volume of the cell
};

/// A particle or its coating: a ball without the smaller ball around the same centre.
template <int dim>
struct Shell {
  Ball<dim> outer;
  double inner_diameter;  ///< [m]; 0 for the whole ball
  PhaseIndex phase;
};

/// The share of a cell of side h [m] that a shell covers, exact to rounding.
template <int dim>
double covered_share(const Shell<dim>& shell, const Vector<dim>& lower, const Vector<dim>& upper, double h) {
  const double cell = times_power<dim>(1.0, h);
  const double whole = overlap(shell.outer, lower, upper) / cell;
  if (shell.inner_diameter == 0.0 || whole == 0.0) return whole;
  return whole - overlap({shell.outer.centre, shell.inner_diameter}, lower, upper) / cell;
}

/// Fills the cells that a shell covers, and lists those that it covers in part.
template <int dim>
void cover(const Shell<dim>& shell, Discretisation<dim>& discretisation, std::vector<Cover>& covers) {
  const auto& grid = discretisation.grid();
  const auto& range = discretisation.range();
  constexpr double rounding = 1e-9;
  const double h = grid.cell_side, radius = 0.5 * shell.outer.diameter;
  Index<dim> begin{}, end{};
  for (std::size_t axis = 0; axis < begin.size(); ++axis) {
    const double lowest = shell.outer.centre[axis] - radius, highest = shell.outer.centre[axis] + radius;
    if (highest < 0.0 || lowest > grid.cells[axis] * h) return;
    const auto cell_of = [&](double x) {
      return static_cast<int>(std::clamp(std::floor(x / h), 0.0, static_cast<double>(grid.cells[axis])));
    };
    begin[axis] = std::max(cell_of(lowest), range.begin[axis]);
    end[axis] = std::min(cell_of(highest) + 1, range.end[axis]);
  }
  for_each_index(begin, end, [&](const Index<dim>& cell) {
    Vector<dim> lower{}, upper{};
    for (std::size_t axis = 0; axis < cell.size(); ++axis) {
      lower[axis] = cell[axis] * h;
      upper[axis] = (cell[axis] + 1) * h;
    }
    const double share = covered_share(shell, lower, upper, h);
    if (share >= 1.0 - rounding) {
      discretisation.fill(cell, shell.phase);
    } else if (share > rounding) {
      covers.push_back({grid.cell_index(cell), shell.phase, share});
    }
  });
}

/// The content of a cell with these covers, which are sorted by phase. Where they fill the cell, the remainder from
/// rounding is added to the largest of them instead of the matrix.
CellContent content_of(std::span<const Cover> covers, PhaseIndex matrix) {
  constexpr double rounding = 1e-9;
  CellContent content = {{matrix, mixture_steps}};
  double all = 0.0;
  for (auto first = covers.begin(); first != covers.end();) {
    const auto phase = first->phase;
    double share = 0.0;
    for (; first != covers.end() && first->phase == phase; ++first) share += first->share;
    all += share;
    const int steps = std::min(to_steps(share), content.front().second);
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

/// Throws InputError where a number does not belong to any phase.
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

template <int dim>
Discretisation<dim> discretise_mixed(const Microstructure<dim>& microstructure, int cells, PhaseIndex matrix,
                                     std::span<const ParticlePhases> particles, std::size_t phases,
                                     const CellLayers& layers) {
  if (particles.size() != microstructure.particles.size()) {
    throw InputError(fmt::format("discretisation: expected a phase for each of {} particles, got {}",
                                 microstructure.particles.size(), particles.size()));
  }
  require_known(matrix, particles, phases);
  Grid<dim> grid{.cell_side = microstructure.side / cells};
  grid.cells.fill(cells);
  Discretisation<dim> discretisation(grid, matrix, layers);
  std::vector<Cover> covers;
  for_each_image(microstructure, [&](std::size_t particle, const Ball<dim>& ball) {
    const auto& [phase, coating, thickness] = particles[particle];
    cover<dim>({ball, 0.0, phase}, discretisation, covers);
    if (thickness > 0.0) {
      cover<dim>({{ball.centre, ball.diameter + 2.0 * thickness}, ball.diameter, coating}, discretisation, covers);
    }
  });
  std::ranges::sort(covers, {}, [](const Cover& one) { return std::tuple(one.cell, one.phase, one.share); });
  MixtureNumbers<dim> numbers(discretisation, phases);
  for (auto first = covers.begin(); first != covers.end();) {
    const auto cell = first->cell;
    const auto end = std::find_if(first, covers.end(), [&](const Cover& one) { return one.cell != cell; });
    const auto index = discretisation.grid().cell_at(cell);
    // A cell that one ball fills stays filled where another ball overlaps it.
    const bool is_filled = discretisation.cell(index).front() != matrix;
    if (!is_filled) numbers.fill(index, content_of({first, end}, matrix));
    first = end;
  }
  return discretisation;
}

template <int dim>
Discretisation<dim> discretise_mixed(const Microstructure<dim>& microstructure, int cells, PhaseIndex matrix,
                                     std::span<const PhaseIndex> particles, std::size_t phases) {
  const auto uncoated = without_coatings(particles);
  return discretise_mixed(microstructure, cells, matrix, std::span<const ParticlePhases>(uncoated), phases);
}

template Discretisation<2> discretise_mixed(const Microstructure<2>&, int, PhaseIndex, std::span<const ParticlePhases>,
                                            std::size_t, const CellLayers&);
template Discretisation<3> discretise_mixed(const Microstructure<3>&, int, PhaseIndex, std::span<const ParticlePhases>,
                                            std::size_t, const CellLayers&);
template Discretisation<2> discretise_mixed(const Microstructure<2>&, int, PhaseIndex, std::span<const PhaseIndex>,
                                            std::size_t);
template Discretisation<3> discretise_mixed(const Microstructure<3>&, int, PhaseIndex, std::span<const PhaseIndex>,
                                            std::size_t);

template <int dim>
std::vector<Material> with_mixtures(const Discretisation<dim>& discretisation, std::vector<Material> materials) {
  const auto phases = materials.size();
  for (const auto& mixture : discretisation.mixtures()) {
    const std::span by_phase = std::span(materials).first(phases);
    materials.push_back(MixtureRule(mixture, by_phase).template material<dim>(by_phase));
  }
  return materials;
}

template std::vector<Material> with_mixtures(const Discretisation<2>&, std::vector<Material>);
template std::vector<Material> with_mixtures(const Discretisation<3>&, std::vector<Material>);

}  // namespace breccia

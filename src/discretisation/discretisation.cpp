#include "breccia/discretisation/discretisation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "discretisation/cell_shape.hpp"

namespace breccia {

namespace {

template <int dim>
const Grid<dim>& require_cells(const Grid<dim>& grid) {
  if (std::ranges::min(grid.cells) < 1 || !(grid.cell_side > 0.0)) {
    throw InputError(fmt::format("discretisation: expected at least one cell of positive side, got {} cells of {} m",
                                 fmt::join(grid.cells, " x "), grid.cell_side));
  }
  return grid;
}

}  // namespace

template <int dim>
Discretisation<dim>::Discretisation(const Grid<dim>& grid, PhaseIndex phase, const CellLayers& layers)
    : grid_(require_cells(grid)), range_(grid.cells_of(layers)) {
  first_ = grid.cell_index(range_.begin);
  count_ = Grid<dim>{.cells = range_.size()}.cell_count();
  CellPhases<dim> cell{};
  cell.fill(phase);
  auto cells = std::make_shared<CellArray<dim>>(count_, cell);
  own_ = cells.get();
  cells_ = std::move(cells);
}

template <int dim>
Discretisation<dim>::Discretisation(const Grid<dim>& grid, SharedCells<dim> cells, std::vector<Mixture> mixtures,
                                    PhaseIndex first_mixture)
    : grid_(require_cells(grid)),
      range_(grid.all_cells()),
      count_(grid.cell_count()),
      cells_(std::move(cells)),
      mixtures_(std::move(mixtures)),
      first_mixture_(first_mixture) {}

template <int dim>
void Discretisation<dim>::take_own_cells() {
  auto cells = std::make_shared<CellArray<dim>>(count_);
  std::ranges::copy(this->cells(), cells.get());
  own_ = cells.get();
  cells_ = std::move(cells);
}

template <int dim>
Vector<dim> Discretisation<dim>::position(const Index<dim>& cell, int point) const noexcept {
  auto position = CellShape<dim>::offset(point);
  for (std::size_t axis = 0; axis < position.size(); ++axis) {
    position[axis] = (cell[axis] + 0.5 + position[axis]) * grid_.cell_side;
  }
  return position;
}

template <int dim>
void Discretisation<dim>::paint(const Ball<dim>& ball, PhaseIndex phase) {
  auto near = range_;
  for (std::size_t axis = 0; axis < near.begin.size(); ++axis) {
    const auto cell_of = [&](double x) {
      return static_cast<int>(
          std::clamp(x, static_cast<double>(range_.begin[axis]), static_cast<double>(range_.end[axis])));
    };
    const double centre = ball.centre[axis], radius = 0.5 * ball.diameter;
    near.begin[axis] = cell_of(std::floor((centre - radius) / grid_.cell_side));
    near.end[axis] = cell_of(std::floor((centre + radius) / grid_.cell_side) + 1.0);
  }
  paint_range(
      near, [&](const Vector<dim>& point) { return ball.contains(point); }, phase);
}

template <int dim>
PhaseIndex Discretisation<dim>::add_mixture(Mixture mixture, std::size_t phases) {
  if (phases + mixtures_.size() >= no_phase) {
    throw InputError(
        fmt::format("discretisation: {} phases and more than {} mixtures of them in mixed cells, which is too many; "
                    "mixing \"points\" "
                    "has none",
                    phases, mixtures_.size()));
  }
  if (mixtures_.empty()) first_mixture_ = static_cast<PhaseIndex>(phases);
  mixtures_.push_back(std::move(mixture));
  return static_cast<PhaseIndex>(first_mixture_ + mixtures_.size() - 1);
}

template <int dim>
std::vector<double> Discretisation<dim>::points_by_phase(std::size_t count) const {
  std::vector<double> points(count, 0.0);
  for (const auto& cell : cells()) {
    for (const auto phase : cell) {
      if (phase == no_phase) continue;
      if (const auto* mixture = this->mixture(phase); mixture != nullptr && phase >= count) {
        for (const auto& part : *mixture) points.at(part.phase) += part.fraction;
      } else {
        points.at(phase) += 1.0;
      }
    }
  }
  return points;
}

template <int dim>
std::vector<double> Discretisation<dim>::fractions(std::size_t count) const {
  auto fractions = points_by_phase(count);
  for (auto& fraction : fractions) fraction /= static_cast<double>(points());
  return fractions;
}

namespace {

[[noreturn]] void refuse_phase(std::string_view calculation, PhaseIndex phase, std::size_t count) {
  throw InputError(fmt::format("{}: a point has the phase with number {}, counted from 0, but only {} {} given",
                               calculation, phase, count, count == 1 ? "material is" : "materials are"));
}

}  // namespace

template <int dim>
void require_phases(std::string_view calculation, const Discretisation<dim>& discretisation, std::size_t count) {
  for (const auto& cell : discretisation.cells()) {
    for (const auto phase : cell) {
      if (phase != no_phase && phase >= count) refuse_phase(calculation, phase, count);
    }
  }
}

template <int dim>
void require_phases_in_cells(std::string_view calculation, const Discretisation<dim>& discretisation,
                             std::size_t count) {
  for (const auto& mixture : discretisation.mixtures()) {
    for (const auto& part : mixture) {
      if (part.phase >= count) refuse_phase(calculation, part.phase, count);
    }
  }
  for (const auto& cell : discretisation.cells()) {
    for (const auto phase : cell) {
      if (phase == no_phase || phase < count || discretisation.mixture(phase) != nullptr) continue;
      refuse_phase(calculation, phase, count);
    }
  }
}

template <int dim>
Discretisation<dim> discretise(const Microstructure<dim>& microstructure, int cells, PhaseIndex matrix,
                               std::span<const ParticlePhases> particles, const CellLayers& layers) {
  const auto count = microstructure.particles.size();
  if (particles.size() != count) {
    throw InputError(
        fmt::format("discretisation: expected a phase for each of {} particles, got {}", count, particles.size()));
  }
  Grid<dim> grid{.cell_side = microstructure.side / cells};
  grid.cells.fill(cells);
  Discretisation<dim> discretisation(grid, matrix, layers);
  for_each_image(microstructure, [&](std::size_t particle, const Ball<dim>& ball) {
    const auto& [phase, coating, thickness] = particles[particle];
    if (thickness > 0.0) discretisation.paint({ball.centre, ball.diameter + 2.0 * thickness}, coating);
    discretisation.paint(ball, phase);
  });
  return discretisation;
}

std::vector<ParticlePhases> without_coatings(std::span<const PhaseIndex> particles) {
  std::vector<ParticlePhases> phases;
  phases.reserve(particles.size());
  for (const auto phase : particles) phases.push_back({phase});
  return phases;
}

template <int dim>
Discretisation<dim> discretise(const Microstructure<dim>& microstructure, int cells, PhaseIndex matrix,
                               std::span<const PhaseIndex> particles) {
  return discretise(microstructure, cells, matrix, without_coatings(particles));
}

template <int dim>
Discretisation<dim> discretise(const Microstructure<dim>& microstructure, int cells, PhaseIndex matrix,
                               PhaseIndex particles) {
  return discretise(microstructure, cells, matrix,
                    std::span<const ParticlePhases>(
                        std::vector<ParticlePhases>(microstructure.particles.size(), ParticlePhases{particles})));
}

template class Discretisation<2>;
template class Discretisation<3>;
template void require_phases(std::string_view, const Discretisation<2>&, std::size_t);
template void require_phases(std::string_view, const Discretisation<3>&, std::size_t);
template void require_phases_in_cells(std::string_view, const Discretisation<2>&, std::size_t);
template void require_phases_in_cells(std::string_view, const Discretisation<3>&, std::size_t);
template Discretisation<2> discretise(const Microstructure<2>&, int, PhaseIndex, std::span<const ParticlePhases>,
                                      const CellLayers&);
template Discretisation<3> discretise(const Microstructure<3>&, int, PhaseIndex, std::span<const ParticlePhases>,
                                      const CellLayers&);
template Discretisation<2> discretise(const Microstructure<2>&, int, PhaseIndex, std::span<const PhaseIndex>);
template Discretisation<3> discretise(const Microstructure<3>&, int, PhaseIndex, std::span<const PhaseIndex>);
template Discretisation<2> discretise(const Microstructure<2>&, int, PhaseIndex, PhaseIndex);
template Discretisation<3> discretise(const Microstructure<3>&, int, PhaseIndex, PhaseIndex);

}  // namespace breccia

#include "breccia/discretisation/discretisation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/discretisation/cell_shape.hpp"
#include "breccia/error.hpp"

namespace breccia {

template <int dim>
Discretisation<dim>::Discretisation(const Grid<dim>& grid, PhaseIndex phase) : grid_(grid) {
  if (std::ranges::min(grid.cells) < 1 || !(grid.cell_side > 0.0)) {
    throw InputError(fmt::format("discretisation: expected at least one cell of positive side, got {} cells of {} m",
                                 fmt::join(grid.cells, " x "), grid.cell_side));
  }
  CellPhases<dim> cell{};
  cell.fill(phase);
  cells_.assign(grid.cell_count(), cell);
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
  const auto cell_of = [&](double x, int count) {
    return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(count)));
  };
  Index<dim> begin{}, end{};
  for (std::size_t axis = 0; axis < begin.size(); ++axis) {
    const double centre = ball.centre[axis], radius = 0.5 * ball.diameter;
    begin[axis] = cell_of(std::floor((centre - radius) / grid_.cell_side), grid_.cells[axis]);
    end[axis] = cell_of(std::floor((centre + radius) / grid_.cell_side) + 1.0, grid_.cells[axis]);
  }
  paint_range(
      begin, end, [&](const Vector<dim>& point) { return ball.contains(point); }, phase);
}

template <int dim>
std::vector<double> Discretisation<dim>::fractions(std::size_t count) const {
  std::vector<double> fractions(count, 0.0);
  for (const auto& cell : cells_) {
    for (const auto phase : cell) {
      if (phase != no_phase) fractions.at(phase) += 1.0;
    }
  }
  for (auto& fraction : fractions) fraction /= static_cast<double>(points());
  return fractions;
}

template <int dim>
void require_phases(std::string_view calculation, const Discretisation<dim>& discretisation, std::size_t count) {
  for (const auto& cell : discretisation.cells()) {
    for (const auto phase : cell) {
      if (phase == no_phase || phase < count) continue;
      throw InputError(fmt::format("{}: a point has the phase with number {}, counted from 0, but only {} {} given",
                                   calculation, phase, count, count == 1 ? "material is" : "materials are"));
    }
  }
}

template <int dim>
Discretisation<dim> discretise(const Microstructure<dim>& microstructure, int cells, PhaseIndex matrix,
                               std::span<const PhaseIndex> particles) {
  const auto count = microstructure.particles.size();
  if (particles.size() != count) {
    throw InputError(
        fmt::format("discretisation: expected a phase for each of {} particles, got {}", count, particles.size()));
  }
  Grid<dim> grid{.cell_side = microstructure.side / cells};
  grid.cells.fill(cells);
  Discretisation<dim> discretisation(grid, matrix);
  const int images = microstructure.walls == Walls::periodic ? 1 : 0;
  Index<dim> first{}, end{};
  first.fill(-images);
  end.fill(images + 1);
  for (std::size_t k = 0; k < count; ++k) {
    for_each_index(first, end, [&](const Index<dim>& image) {
      auto ball = microstructure.particles[k];
      for (std::size_t axis = 0; axis < image.size(); ++axis) ball.centre[axis] += image[axis] * microstructure.side;
      discretisation.paint(ball, particles[k]);
    });
  }
  return discretisation;
}

template <int dim>
Discretisation<dim> discretise(const Microstructure<dim>& microstructure, int cells, PhaseIndex matrix,
                               PhaseIndex particles) {
  return discretise(microstructure, cells, matrix, std::vector<PhaseIndex>(microstructure.particles.size(), particles));
}

template class Discretisation<2>;
template class Discretisation<3>;
template void require_phases(std::string_view, const Discretisation<2>&, std::size_t);
template void require_phases(std::string_view, const Discretisation<3>&, std::size_t);
template Discretisation<2> discretise(const Microstructure<2>&, int, PhaseIndex, std::span<const PhaseIndex>);
template Discretisation<3> discretise(const Microstructure<3>&, int, PhaseIndex, std::span<const PhaseIndex>);
template Discretisation<2> discretise(const Microstructure<2>&, int, PhaseIndex, PhaseIndex);
template Discretisation<3> discretise(const Microstructure<3>&, int, PhaseIndex, PhaseIndex);

}  // namespace breccia

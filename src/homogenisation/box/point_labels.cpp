#include "breccia/homogenisation/point_labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "breccia/homogenisation/stage_discretisation.hpp"

#include "microstructure/shapes/ellipsoid_locator.hpp"
#include "microstructure/shapes/particle_locator.hpp"
#include "microstructure/tessellation/grain_locator.hpp"
#include "study/coatings.hpp"

namespace breccia {
namespace {

constexpr std::int32_t no_particle = -1;

template <int dim>
Grid<dim> grid_of(double side, int cells) {
  Grid<dim> grid = {.cells = {}, .cell_side = side / cells};
  grid.cells.fill(cells);
  return grid;
}

template <int dim>
std::vector<PhaseIndex> phases_of_points(const Discretisation<dim>& discretisation) {
  const auto& grid = discretisation.grid();
  std::vector<PhaseIndex> phases(discretisation.points());
  grid.for_each_cell([&](const Index<dim>& cell) {
    const auto& of_cell = discretisation.cell(cell);
    for (int point = 0; point < Discretisation<dim>::points_per_cell; ++point) {
      phases[grid.point_index(cell, point)] = of_cell[static_cast<std::size_t>(point)];
    }
  });
  return phases;
}

/// Calls action(index in the list of points) for the points in a ball. `along` is the number of points along each side
/// of the box, which are `spacing` [m] apart.
template <int dim, class Action>
void for_each_point_in(const Ball<dim>& ball, int along, double spacing, Action&& action) {
  const double radius = 0.5 * ball.diameter;
  const auto point_at = [&](double x) {
    return static_cast<int>(std::clamp(std::floor(x / spacing), 0.0, static_cast<double>(along)));
  };
  Index<dim> begin{}, end{};
  for (std::size_t axis = 0; axis < begin.size(); ++axis) {
    begin[axis] = point_at(ball.centre[axis] - radius);
    end[axis] = std::min(point_at(ball.centre[axis] + radius) + 1, along);
  }
  for_each_index(begin, end, [&](const Index<dim>& point) {
    double squared_distance = 0.0;
    std::size_t place = 0;
    for (std::size_t axis = point.size(); axis-- > 0;) {
      const double x = (point[axis] + 0.5) * spacing - ball.centre[axis];
      squared_distance += x * x;
      place = place * static_cast<std::size_t>(along) + static_cast<std::size_t>(point[axis]);
    }
    if (squared_distance <= radius * radius) action(place);
  });
}

/// The number of the ball at every point outside the matrix.
template <int dim>
std::vector<std::int32_t> particles_of_points(const Stage& stage, const Microstructure<dim>& microstructure, int cells,
                                              const std::vector<PhaseIndex>& phases) {
  const auto matrix = phases_of(stage).index_of(name_of_matrix_phase);
  std::vector<std::int32_t> particles(phases.size(), no_particle);
  const int along = 2 * cells;
  for_each_image(with_coatings(stage, microstructure), [&](std::size_t particle, const Ball<dim>& ball) {
    for_each_point_in(ball, along, stage.side / along, [&](std::size_t point) {
      if (phases[point] != matrix) particles[point] = static_cast<std::int32_t>(particle);
    });
  });
  return particles;
}

/// The number of the particle at every point that lies in a particle or in its coating.
template <int dim, class Locator, class Shaped>
std::vector<std::int32_t> particles_near_points(const Shaped& box, int cells) {
  const Locator locator(box);
  const Discretisation<dim> points(grid_of<dim>(box.side, cells));
  std::vector<std::int32_t> particles(points.points(), no_particle);
  points.grid().for_each_cell([&](const Index<dim>& cell) {
    for (int point = 0; point < Discretisation<dim>::points_per_cell; ++point) {
      const auto [particle, distance] = locator.at(points.position(cell, point));
      if (!particle || distance > box.coating_of(*particle)) continue;
      particles[points.grid().point_index(cell, point)] = static_cast<std::int32_t>(*particle);
    }
  });
  return particles;
}

/// The labels of the points of a box: a visitor of its content.
template <int dim>
struct LabelsIn {
  const Stage& stage;
  const Box<dim>& box;
  int cells;

  PointLabels operator()(const Microstructure<dim>& balls) const {
    auto phases = phases_in_box();
    auto particles = particles_of_points(stage, balls, cells, phases);
    return {std::move(phases), std::move(particles)};
  }
  PointLabels operator()(const ParticleBox& shaped) const {
    return {phases_in_box(), particles_near_points<2, ParticleLocator>(shaped, cells)};
  }
  PointLabels operator()(const EllipsoidBox& shaped) const {
    return {phases_in_box(), particles_near_points<3, EllipsoidLocator>(shaped, cells)};
  }
  PointLabels operator()(const SharedImage<dim>&) const { return {phases_in_box(), {}}; }
  PointLabels operator()(const Grains<dim>& grains) const {
    const auto phases = phases_of(stage);
    const auto matrix = phases.index_of(name_of_matrix_phase);
    const auto filler = phases.index_of(phase_of(stage, stage.fillers.front().material));
    const GrainLocator<dim> locator(Tessellation<dim>(grains.sites), grains.statistics.film);
    const auto grid = grid_of<dim>(stage.side, cells);
    const Discretisation<dim> points(grid);
    PointLabels labels = {.phases = std::vector<PhaseIndex>(points.points(), matrix),
                          .particles = std::vector<std::int32_t>(points.points(), no_particle)};
    grid.for_each_cell([&](const Index<dim>& cell) {
      for (int point = 0; point < Discretisation<dim>::points_per_cell; ++point) {
        const auto place = locator.at(points.position(cell, point));
        if (!place.is_in_grain()) continue;
        const auto index = grid.point_index(cell, point);
        labels.phases[index] = filler;
        labels.particles[index] = static_cast<std::int32_t>(place.site);
      }
    });
    return labels;
  }

 private:
  [[nodiscard]] std::vector<PhaseIndex> phases_in_box() const {
    return phases_of_points(discretise(stage, box, cells, Mixing::points));
  }
};

template <int dim>
PointLabels labels_in(const Stage& stage, const Box<dim>& box, int cells) {
  return std::visit(LabelsIn<dim>{stage, box, cells}, box);
}

}  // namespace

PointLabels point_labels(const Stage& stage, const StageMicrostructure& packed, int cells) {
  return std::visit([&](const auto& box) { return labels_in(stage, box, cells); }, packed.box);
}

}  // namespace breccia

#include "breccia/homogenisation/point_labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/microstructure/grain_locator.hpp"
#include "breccia/microstructure/particle_locator.hpp"
#include "breccia/study/coatings.hpp"

namespace breccia {
namespace {

constexpr std::int32_t no_particle = -1;

std::vector<PhaseIndex> phases_of_points(const Discretisation<2>& discretisation) {
  const auto& grid = discretisation.grid();
  std::vector<PhaseIndex> phases(discretisation.points());
  grid.for_each_cell([&](const Index<2>& cell) {
    const auto& of_cell = discretisation.cell(cell);
    for (int point = 0; point < Discretisation<2>::points_per_cell; ++point) {
      phases[grid.point_index(cell, point)] = of_cell[static_cast<std::size_t>(point)];
    }
  });
  return phases;
}

/// Calls action(index in the list of points) for the points in a disc. `along` is the number of points along each side
/// of the box, which are `spacing` [m] apart.
template <class Action>
void for_each_point_in(const Disc& disc, int along, double spacing, Action&& action) {
  const double radius = 0.5 * disc.diameter;
  const auto point_at = [&](double x) {
    return static_cast<int>(std::clamp(std::floor(x / spacing), 0.0, static_cast<double>(along)));
  };
  Index<2> begin{}, end{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    begin[axis] = point_at(disc.centre[axis] - radius);
    end[axis] = std::min(point_at(disc.centre[axis] + radius) + 1, along);
  }
  for_each_index(begin, end, [&](const Index<2>& point) {
    const double x = (point[0] + 0.5) * spacing - disc.centre[0], y = (point[1] + 0.5) * spacing - disc.centre[1];
    if (x * x + y * y <= radius * radius) {
      action(static_cast<std::size_t>(point[1]) * static_cast<std::size_t>(along) + static_cast<std::size_t>(point[0]));
    }
  });
}

/// The particle of every point that is not of the matrix.
std::vector<std::int32_t> particles_of_points(const Stage& stage, const Microstructure<2>& microstructure, int cells,
                                              const std::vector<PhaseIndex>& phases) {
  const auto matrix = phases_of(stage).index_of(name_of_matrix_phase);
  std::vector<std::int32_t> particles(phases.size(), no_particle);
  const int along = 2 * cells;
  for_each_image(with_coatings(stage, microstructure), [&](std::size_t particle, const Disc& disc) {
    for_each_point_in(disc, along, stage.side / along, [&](std::size_t point) {
      if (phases[point] != matrix) particles[point] = static_cast<std::int32_t>(particle);
    });
  });
  return particles;
}

/// The particle of every point in it or in its coating.
std::vector<std::int32_t> particles_of_points(const ParticleBox& box, int cells) {
  const ParticleLocator locator(box);
  const Discretisation<2> points(Grid<2>{{cells, cells}, box.side / cells});
  std::vector<std::int32_t> particles(points.points(), no_particle);
  points.grid().for_each_cell([&](const Index<2>& cell) {
    for (int point = 0; point < Discretisation<2>::points_per_cell; ++point) {
      const auto [particle, distance] = locator.at(points.position(cell, point));
      if (!particle || distance > box.coating_of(*particle)) continue;
      particles[points.grid().point_index(cell, point)] = static_cast<std::int32_t>(*particle);
    }
  });
  return particles;
}

PointLabels labels_of_grains(const Stage& stage, const StageGrains& grains, int cells) {
  const auto phases = phases_of(stage);
  const auto matrix = phases.index_of(name_of_matrix_phase);
  const auto filler = phases.index_of(phase_of(stage, stage.fillers.front().material));
  const GrainLocator<2> locator(Tessellation<2>(grains.sites), grains.film);
  const Discretisation<2> points(Grid<2>{{cells, cells}, stage.side / cells});
  PointLabels labels = {.phases = std::vector<PhaseIndex>(points.points(), matrix),
                        .particles = std::vector<std::int32_t>(points.points(), no_particle)};
  points.grid().for_each_cell([&](const Index<2>& cell) {
    for (int point = 0; point < Discretisation<2>::points_per_cell; ++point) {
      const auto place = locator.at(points.position(cell, point));
      if (!place.is_in_grain()) continue;
      const auto index = points.grid().point_index(cell, point);
      labels.phases[index] = filler;
      labels.particles[index] = static_cast<std::int32_t>(place.site);
    }
  });
  return labels;
}

}  // namespace

PointLabels point_labels(const Stage& stage, const StageMicrostructure& packed, int cells) {
  if (packed.grains) return labels_of_grains(stage, *packed.grains, cells);
  PointLabels labels = {.phases = phases_of_points(discretise(stage, packed, cells, Mixing::points)), .particles = {}};
  if (packed.shaped) {
    labels.particles = particles_of_points(*packed.shaped, cells);
  } else if (stage.image() == nullptr) {
    labels.particles = particles_of_points(stage, packed.microstructure, cells, labels.phases);
  }
  return labels;
}

}  // namespace breccia

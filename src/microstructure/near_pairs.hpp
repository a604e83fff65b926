#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"

#include "microstructure/level_grid.hpp"
#include "microstructure/periodic_images.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia {

/// Calls visit(particle, other, seen) for pairs of particles in balls of these (positive) radii [m] around centres in
/// the box, at least for those whose balls are nearer than `reach` [m]; once for each image in a periodic box. `seen`
/// is the centre of the other particle or of its image [m].
template <int dim, class Visit>
void visit_near_pairs(double side, Walls walls, const std::vector<Vector<dim>>& centres,
                      const std::vector<double>& radii, double reach, Visit&& visit) {
  LevelGrid<dim> grid(side, walls, radii);
  const PeriodicImages<dim> images(side);
  std::vector<std::uint32_t> order(centres.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&grid](std::uint32_t particle) { return grid.level(particle); });
  for (const std::uint32_t particle : order) {
    grid.visit_near(centres[particle], radii[particle] + reach, [&](std::uint32_t other, std::uint32_t image) {
      visit(particle, other, centres[other] + images.shift(image));
    });
    grid.insert(particle, centres[particle]);
  }
}

}  // namespace breccia

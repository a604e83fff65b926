#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"

#include "level_grid.hpp"
#include "periodic_images.hpp"
#include "vector_algebra.hpp"

namespace breccia {

/// Calls visit(ball, other, gap) for every pair of balls whose surfaces are nearer than `reach` [m], once for each
/// image in a periodic box. Diameters are positive.
template <int dim, class Visit>
void visit_close_pairs(double side, Walls walls, const std::vector<Ball<dim>>& balls, double reach, Visit&& visit) {
  std::vector<double> radii;
  radii.reserve(balls.size());
  for (const auto& ball : balls) radii.push_back(0.5 * ball.diameter);
  LevelGrid<dim> grid(side, walls, radii);
  const PeriodicImages<dim> images(side);
  std::vector<std::uint32_t> order(balls.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&grid](std::uint32_t ball) { return grid.level(ball); });
  for (const std::uint32_t ball : order) {
    const Vector<dim>& centre = balls[ball].centre;
    grid.visit_near(centre, radii[ball] + reach, [&](std::uint32_t other, std::uint32_t image) {
      const Vector<dim> seen = displaced(balls[other].centre, 1.0, images.shift(image));
      const double gap = norm(difference(seen, centre)) - radii[ball] - radii[other];
      if (gap < reach) visit(ball, other, gap);
    });
    grid.insert(ball, centre);
  }
}

/// Smallest distance between the surfaces of two balls [m], or of a ball and its own image in a periodic box. Infinite
/// if there are no two.
template <int dim>
[[nodiscard]] double smallest_gap(double side, Walls walls, const std::vector<Ball<dim>>& balls) {
  double smallest = std::numeric_limits<double>::infinity();
  if (balls.empty()) return smallest;
  if (walls == Walls::periodic) smallest = side - std::ranges::max(balls, {}, &Ball<dim>::diameter).diameter;
  const double diagonal = side * std::sqrt(static_cast<double>(dim));
  double reach = 0.1 * side * std::pow(static_cast<double>(balls.size()), -1.0 / dim);
  bool found = false;
  do {
    visit_close_pairs(side, walls, balls, reach, [&](std::uint32_t, std::uint32_t, double gap) {
      found = true;
      smallest = std::min(smallest, gap);
    });
    reach *= 4.0;
  } while (!found && reach < 4.0 * diagonal);
  return smallest;
}

}  // namespace breccia

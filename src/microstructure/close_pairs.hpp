#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"

#include "microstructure/near_pairs.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia {

/// Calls visit(ball, other, gap) for every pair of balls whose surfaces are nearer than `reach` [m], once for each
/// image in a periodic box. Diameters are positive.
template <int dim, class Visit>
void visit_close_pairs(double side, Walls walls, const std::vector<Ball<dim>>& balls, double reach, Visit&& visit) {
  std::vector<Vector<dim>> centres;
  std::vector<double> radii;
  for (const auto& ball : balls) {
    centres.push_back(ball.centre);
    radii.push_back(0.5 * ball.diameter);
  }
  visit_near_pairs<dim>(side, walls, centres, radii, reach,
                        [&](std::uint32_t ball, std::uint32_t other, const Vector<dim>& seen) {
                          const double gap = norm(seen - centres[ball]) - radii[ball] - radii[other];
                          if (gap < reach) visit(ball, other, gap);
                        });
}

/// Smallest distance between the surfaces of two balls [m], or of a ball and its own image in a periodic box. Infinite
/// if there are no two balls.
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

#pragma once

#include <cstdint>
#include <vector>

#include "breccia/microstructure/particle_box.hpp"

#include "microstructure/near_pairs.hpp"

namespace breccia {

/// Calls visit(particle, other, gap) for every pair of particles whose outlines are nearer than `reach` [m], without
/// coatings, once for each image in a periodic box. Gaps are exact where they are less than `reach`.
template <class Visit>
void visit_particle_pairs(const ParticleBox& box, double reach, Visit&& visit) {
  std::vector<Vector<2>> centres;
  std::vector<double> radii;
  for (const auto& [shape, pose] : box.particles) {
    centres.push_back(pose.centre());
    radii.push_back(circumradius(shape));
  }
  visit_near_pairs<2>(box.side, box.walls, centres, radii, reach,
                      [&](std::uint32_t number, std::uint32_t behind, const Vector<2>& seen) {
                        const auto& [shape, pose] = box.particles[number];
                        const auto& other = box.particles[behind];
                        const double width = gap(shape, pose, other.shape, other.pose.at(seen)).width;
                        if (width < reach) visit(number, behind, width);
                      });
}

/// Smallest distance between the outline of a particle and its own images in a periodic box of this side [m].
[[nodiscard]] inline double gap_to_own_images(const Particle& particle, double side) {
  const auto& [shape, pose] = particle;
  const auto& [x, y] = pose.centre();
  double smallest = side;
  for (const Vector<2>& image : {Vector<2>{side, 0.0}, {0.0, side}, {side, side}, {side, -side}}) {
    const auto seen = pose.at({x + image[0], y + image[1]});
    smallest = std::min(smallest, gap(shape, pose, shape, seen).width);
  }
  return smallest;
}

}  // namespace breccia

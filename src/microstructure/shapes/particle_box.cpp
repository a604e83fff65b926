#include "breccia/microstructure/particle_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "microstructure/shapes/particle_pairs.hpp"

namespace breccia {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Distance between a particle and the nearest side of the box [m]; negative where it crosses one.
double distance_from_sides(const Particle& particle, double side) {
  const auto reach = extent(particle.shape, particle.pose);
  double smallest = infinite;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double x = particle.pose.centre()[axis];
    smallest = std::min({smallest, x - reach[axis][0], side - x - reach[axis][1]});
  }
  return smallest;
}

}  // namespace

std::optional<Microstructure<2>> as_discs(const ParticleBox& box) {
  Microstructure<2> discs = {box.side, box.walls, {}, box.fillers};
  for (const auto& [shape, pose] : box.particles) {
    const auto* ellipse = std::get_if<Ellipse>(&shape);
    if (ellipse == nullptr || ellipse->axes[0] != ellipse->axes[1]) return std::nullopt;
    discs.particles.push_back({pose.centre(), ellipse->axes[0]});
  }
  return discs;
}

ParticleBox as_particles(const Microstructure<2>& discs) {
  ParticleBox box = {discs.side, discs.walls, {}, discs.fillers};
  for (const auto& [centre, diameter] : discs.particles) {
    box.particles.push_back({Ellipse{{diameter, diameter}}, Pose(centre, 0.0)});
  }
  return box;
}

double volume_fraction(const ParticleBox& box) {
  double sum = 0.0;
  for (const auto& particle : box.particles) sum += area(particle.shape);
  return sum / (box.side * box.side);
}

double coating_fraction(const ParticleBox& box) {
  double sum = 0.0;
  for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
    // This is Steiner's formula for the points within a distance of a convex set.
    const double thickness = box.coating_of(particle);
    sum += perimeter(box.particles[particle].shape) * thickness + std::numbers::pi * thickness * thickness;
  }
  return sum / (box.side * box.side);
}

double specific_surface(const ParticleBox& box) {
  double sum = 0.0;
  for (const auto& particle : box.particles) sum += perimeter(particle.shape);
  return sum / (box.side * box.side);
}

double smallest_gap(const ParticleBox& box) {
  double smallest = infinite;
  if (box.walls == Walls::periodic) {
    for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
      const double own = gap_to_own_images(box.particles[particle], box.side);
      smallest = std::min(smallest, own - 2.0 * box.coating_of(particle));
    }
  }
  if (box.particles.size() < 2) return smallest;
  const double thickest = box.coatings.empty() ? 0.0 : std::ranges::max(box.coatings);
  const double diagonal = std::numbers::sqrt2 * box.side;
  double reach = 2.0 * thickest + 0.1 * box.side / std::sqrt(static_cast<double>(box.particles.size()));
  // A pair whose outlines are farther apart than the reach may have a smaller gap between its coatings than the gap
  // found, by up to twice the thickest coating.
  bool is_certain = false;
  while (!is_certain && reach < 4.0 * diagonal) {
    visit_particle_pairs(box, reach, [&](std::uint32_t one, std::uint32_t other, double width) {
      smallest = std::min(smallest, width - box.coating_of(one) - box.coating_of(other));
    });
    is_certain = smallest <= reach - 2.0 * thickest;
    reach *= 4.0;
  }
  return smallest;
}

double smallest_wall_gap(const ParticleBox& box) {
  double smallest = infinite;
  if (box.walls == Walls::periodic) return smallest;
  for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
    smallest = std::min(smallest, distance_from_sides(box.particles[particle], box.side) - box.coating_of(particle));
  }
  return smallest;
}

double smallest_side_distance(const ParticleBox& box) {
  double smallest = infinite;
  for (const auto& particle : box.particles) smallest = std::min(smallest, distance_from_sides(particle, box.side));
  return smallest;
}

}  // namespace breccia

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"
#include "breccia/microstructure/particle.hpp"

namespace breccia {

/// A square box [0, side]^2 with convex particles of any shape. Each particle of a periodic box is listed once, with
/// its centre in the box. (A box of balls alone, in any dimension, is a Microstructure.)
struct ParticleBox {
  double side = 0.0;  ///< [m]
  Walls walls = Walls::hard;
  std::vector<Particle> particles = {};
  /// The number of the filler that each particle belongs to, from 0; empty where all belong to the first.
  std::vector<std::size_t> fillers = {};
  /// Thickness of the coating around each particle [m]; empty where no particle has a coating.
  std::vector<double> coatings = {};

  [[nodiscard]] std::size_t filler_of(std::size_t particle) const { return fillers.empty() ? 0 : fillers.at(particle); }
  [[nodiscard]] double coating_of(std::size_t particle) const { return coatings.empty() ? 0.0 : coatings.at(particle); }
};

/// The box with its particles as discs, if all of them are circles; nothing otherwise.
[[nodiscard]] std::optional<Microstructure<2>> as_discs(const ParticleBox& box);

/// The box with its discs as particles.
[[nodiscard]] ParticleBox as_particles(const Microstructure<2>& discs);

/// Calls action(number, pose) for every particle and, in a periodic box, for its images in the neighbouring boxes.
template <class Action>
void for_each_image(const ParticleBox& box, Action&& action) {
  const int images = box.walls == Walls::periodic ? 1 : 0;
  const Index<2> first = {-images, -images}, end = {images + 1, images + 1};
  for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
    const auto& pose = box.particles[particle].pose;
    for_each_index(first, end, [&](const Index<2>& image) {
      action(particle, pose.at({pose.centre()[0] + image[0] * box.side, pose.centre()[1] + image[1] * box.side}));
    });
  }
}

/// Area of the particles per area of the box, without coatings.
[[nodiscard]] double volume_fraction(const ParticleBox& box);
/// Area of the coatings per area of the box.
[[nodiscard]] double coating_fraction(const ParticleBox& box);
/// Length of the outlines of the particles per area of the box [1/m].
[[nodiscard]] double specific_surface(const ParticleBox& box);
/// Smallest distance between two particles with their coatings [m], across the sides too if the box is periodic (where
/// a particle also faces its own image). Negative if two overlap, infinite if there are no two.
[[nodiscard]] double smallest_gap(const ParticleBox& box);
/// Smallest distance between a particle with its coating and a hard wall [m]. Negative if one crosses a wall, infinite
/// if there are no particles or no walls.
[[nodiscard]] double smallest_wall_gap(const ParticleBox& box);
/// Smallest distance between a particle without its coating and a side of the box [m]; negative where one crosses it.
[[nodiscard]] double smallest_side_distance(const ParticleBox& box);

}  // namespace breccia

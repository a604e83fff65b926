#pragma once

#include <cstddef>
#include <vector>

#include "breccia/microstructure/ball.hpp"
#include "breccia/microstructure/index.hpp"

namespace breccia {

/// The kind of walls at the sides of a box.
enum class Walls {
  hard,     ///< particles stay inside the box
  periodic  ///< particles leave on one side and enter on the other
};

/// A square or cubic box [0, side]^dim with particles. Particles of a periodic box are listed once, with their centre
/// in the box.
template <int dim>
struct Microstructure {
  double side = 0.0;  ///< [m]
  Walls walls = Walls::hard;
  std::vector<Ball<dim>> particles;
  /// The number of the filler that each particle belongs to, from 0; empty where all belong to the first.
  std::vector<std::size_t> fillers = {};

  [[nodiscard]] std::size_t filler_of(std::size_t particle) const { return fillers.empty() ? 0 : fillers.at(particle); }
};

/// Calls action(number, ball) for every particle and, in a periodic box, for its images in the neighbouring boxes.
template <int dim, class Action>
void for_each_image(const Microstructure<dim>& microstructure, Action&& action) {
  const int images = microstructure.walls == Walls::periodic ? 1 : 0;
  Index<dim> first{}, end{};
  first.fill(-images);
  end.fill(images + 1);
  for (std::size_t particle = 0; particle < microstructure.particles.size(); ++particle) {
    for_each_index(first, end, [&](const Index<dim>& image) {
      auto ball = microstructure.particles[particle];
      for (std::size_t axis = 0; axis < image.size(); ++axis) ball.centre[axis] += image[axis] * microstructure.side;
      action(particle, ball);
    });
  }
}

}  // namespace breccia

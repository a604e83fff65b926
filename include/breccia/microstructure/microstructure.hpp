#pragma once

#include <vector>

#include "breccia/microstructure/ball.hpp"

namespace breccia {

/// What the sides of the box do to particles.
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
};

}  // namespace breccia

#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace breccia {

/// A position or displacement in `dim` dimensions [m].
template <int dim>
using Vector = std::array<double, static_cast<std::size_t>(dim)>;

/// A ball: a disc in 2D, a sphere in 3D.
template <int dim>
struct Ball {
  Vector<dim> centre;  ///< [m]
  double diameter;     ///< [m]

  /// Is the point inside or on the surface?
  [[nodiscard]] bool contains(const Vector<dim>& point) const noexcept {
    double squared_distance = 0.0;
    for (std::size_t d = 0; d < centre.size(); ++d) squared_distance += (point[d] - centre[d]) * (point[d] - centre[d]);
    return 4.0 * squared_distance <= diameter * diameter;
  }

  friend bool operator==(const Ball&, const Ball&) = default;
};
using Disc = Ball<2>;

/// What the sides of the box do to particles.
enum class Walls {
  hard,     ///< particles stay inside the box
  periodic  ///< particles leave on one side and enter on the other
};

/// A square box [0, side]^2 with discs. Discs of a periodic box are listed once, with their centre in the box.
struct Microstructure {
  double side = 0.0;  ///< [m]
  Walls walls = Walls::hard;
  std::vector<Disc> discs;
};

}  // namespace breccia

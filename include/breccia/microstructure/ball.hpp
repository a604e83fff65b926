#pragma once

#include <cstddef>
#include <numbers>

#include "breccia/microstructure/vector.hpp"

namespace breccia {

/// A ball: a disc in 2D, a sphere in 3D.
template <int dim>
struct Ball {
  Vector<dim> centre;  ///< [m]
  double diameter;     ///< [m]

  /// Whether a point is inside the ball or on its surface.
  [[nodiscard]] bool contains(const Vector<dim>& point) const noexcept {
    double squared_distance = 0.0;
    for (std::size_t d = 0; d < centre.size(); ++d) squared_distance += (point[d] - centre[d]) * (point[d] - centre[d]);
    return 4.0 * squared_distance <= diameter * diameter;
  }

  friend bool operator==(const Ball&, const Ball&) = default;
};
using Disc = Ball<2>;
using Sphere = Ball<3>;

/// Area of a disc [m^2], volume of a sphere [m^3].
template <int dim>
[[nodiscard]] constexpr double ball_volume(double diameter) noexcept {
  return times_power<dim>(std::numbers::pi / (2.0 * dim), diameter);
}

/// Circumference of a disc [m], surface of a sphere [m^2].
template <int dim>
[[nodiscard]] constexpr double ball_surface(double diameter) noexcept {
  return times_power<dim - 1>(std::numbers::pi, diameter);
}

}  // namespace breccia

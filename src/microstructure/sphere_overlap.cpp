#include "microstructure/sphere_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "breccia/microstructure/index.hpp"

namespace breccia {
namespace {

// All lengths below are in radii of the sphere, whose centre is the origin; x, y, z, a and b are between 0 and 1.

/// Volume of the sphere where x > a, y > 0 and z > 0.
double beyond_plane(double a) {
  return std::numbers::pi / 12.0 * (1.0 - a) * (1.0 - a) * (2.0 + a);
}

/// Volume of the sphere where x > a, y > b and z > 0 (theory, Eq. 42b).
double beyond_planes(double a, double b) {
  const double square = 1.0 - a * a - b * b;
  if (square <= 0.0) return 0.0;
  const double w = std::sqrt(square);  // the height at which both planes leave the sphere
  return (std::atan2(w, a * b) + a * b * w) / 3.0 - 0.5 * a * (1.0 - a * a / 3.0) * std::atan2(w, b) -
         0.5 * b * (1.0 - b * b / 3.0) * std::atan2(w, a);
}

/// Volume of the sphere between the origin and a corner.
double in_octant(double x, double y, double z) {
  if (x * x + y * y + z * z <= 1.0) return x * y * z;
  return std::numbers::pi / 6.0 - beyond_plane(x) - beyond_plane(y) - beyond_plane(z) + beyond_planes(x, y) +
         beyond_planes(y, z) + beyond_planes(z, x);
}

/// Volume of the sphere between the origin and a corner in any octant, as an odd function of each coordinate.
double up_to(const Vector<3>& corner) {
  const auto distance = [&](std::size_t axis) { return std::min(std::abs(corner[axis]), 1.0); };
  const double volume = in_octant(distance(0), distance(1), distance(2));
  const bool is_negative = (corner[0] < 0.0) != ((corner[1] < 0.0) != (corner[2] < 0.0));
  return is_negative ? -volume : volume;
}

}  // namespace

double overlap_volume(const Sphere& sphere, const Vector<3>& lower, const Vector<3>& upper) {
  const double radius = 0.5 * sphere.diameter;
  Vector<3> from{}, to{};
  double box = 1.0, nearest = 0.0, farthest = 0.0;  // squares of the distances of the box from the centre
  for (std::size_t axis = 0; axis < 3; ++axis) {
    from[axis] = (lower[axis] - sphere.centre[axis]) / radius;
    to[axis] = (upper[axis] - sphere.centre[axis]) / radius;
    box *= upper[axis] - lower[axis];
    const double near = std::max({0.0, from[axis], -to[axis]}), far = std::max(-from[axis], to[axis]);
    nearest += near * near;
    farthest += far * far;
  }
  if (nearest >= 1.0) return 0.0;
  if (farthest <= 1.0) return box;
  double sum = 0.0;
  for_each_index(Index<3>{0, 0, 0}, Index<3>{2, 2, 2}, [&](const Index<3>& corner) {
    const auto along = [&](std::size_t axis) { return (corner[axis] == 1 ? to : from)[axis]; };
    const double part = up_to({along(0), along(1), along(2)});
    sum += (corner[0] + corner[1] + corner[2]) % 2 == 1 ? part : -part;
  });
  return std::clamp(times_power<3>(sum, radius), 0.0, box);
}

}  // namespace breccia

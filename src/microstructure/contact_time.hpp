#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "microstructure/vector_algebra.hpp"

namespace breccia {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// The first t >= 0 at which two growing balls touch, |r + v t| = distance + rate t, or `never`. `r` and `v` are their
/// relative position and velocity, `distance` is the sum of their radii. Balls that overlap by roundoff touch at t = 0
/// if they approach, and never if they separate.
template <std::size_t dim>
[[nodiscard]] inline double contact_time(const std::array<double, dim>& r, const std::array<double, dim>& v,
                                         double distance, double rate) noexcept {
  // a t^2 + 2 b t + c = 0, in the form that does not cancel
  const double b = dot(r, v) - distance * rate;
  const double a = dot(v, v) - rate * rate;
  if (b >= 0.0 && a >= 0.0) return never;
  const double c = dot(r, r) - distance * distance;
  if (c <= 0.0) return b < 0.0 ? 0.0 : never;
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) return never;
  const double root = std::sqrt(discriminant);
  return b < 0.0 ? c / (root - b) : -(b + root) / a;
}

/// The time at which a point at `r` with velocity `v` leaves the ball of the given radius around the origin.
template <std::size_t dim>
[[nodiscard]] inline double leave_time(const std::array<double, dim>& r, const std::array<double, dim>& v,
                                       double radius) noexcept {
  const double a = dot(v, v);
  if (a == 0.0) return never;
  const double b = dot(r, v);
  const double c = dot(r, r) - radius * radius;
  if (c >= 0.0) return b > 0.0 ? 0.0 : -2.0 * b / a;
  const double root = std::sqrt(b * b - a * c);
  return b > 0.0 ? -c / (root + b) : (root - b) / a;
}

}  // namespace breccia

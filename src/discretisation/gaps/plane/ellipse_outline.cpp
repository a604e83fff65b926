#include "discretisation/gaps/plane/ellipse_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

/// The nearest point of an ellipse, with its longer half axis a along x, to a point with coordinates that are not
/// negative: (a^2 x / (s + a^2), b^2 y / (s + b^2)), where s, above -b^2, makes it a point of the ellipse.
Vector<2> nearest_point(double a, double b, const Vector<2>& point) {
  const auto [x, y] = point;
  const double excess = (a - b) * (a + b);
  if (y <= 1e-14 * b) {
    // Near the centre the nearest point is not on the axis.
    if (a * x >= excess) return {a, 0.0};
    const double share = a * x / excess;
    return {a * share, b * std::sqrt((1.0 - share) * (1.0 + share))};
  }
  // The sum of squares falls with s and is convex, so that Newton's method from the left does not overshoot.
  constexpr int most_steps = 200;
  double s = b * (y - b);
  for (int step = 0; step < most_steps; ++step) {
    const double along_a = a * x / (s + a * a), along_b = b * y / (s + b * b);
    const double too_large = along_a * along_a + along_b * along_b - 1.0;
    const double slope = 2.0 * (along_a * along_a / (s + a * a) + along_b * along_b / (s + b * b));
    const double next = s + too_large / slope;
    if (!(next > s)) break;
    s = next;
  }
  return {a * a * x / (s + a * a), b * b * y / (s + b * b)};
}

/// Area that the unit disc and the triangle between its centre and two points have in common; negative where the points
/// run clockwise.
double area_of_triangle_in_unit_disc(const Vector<2>& begin, const Vector<2>& end) {
  const auto along = end - begin;
  const auto sector = [](const Vector<2>& one, const Vector<2>& other) {
    return 0.5 * std::atan2(cross(one, other), dot(one, other));
  };
  // The places on the side, from 0 to 1, where it crosses the circle.
  const double square = dot(along, along), half = dot(begin, along),
               free = half * half - square * (dot(begin, begin) - 1.0);
  if (square == 0.0) return 0.0;
  if (free <= 0.0) return sector(begin, end);
  const double root = std::sqrt(free);
  const double enters = std::clamp((-half - root) / square, 0.0, 1.0),
               leaves = std::clamp((-half + root) / square, 0.0, 1.0);
  const auto first = begin + enters * along, last = begin + leaves * along;
  return sector(begin, first) + 0.5 * cross(first, last) + sector(last, end);
}

}  // namespace

FromOutline from_outline(const EllipseOutline& ellipse, const Vector<2>& point) noexcept {
  const auto seen = ellipse.pose.to_shape(point - ellipse.pose.centre());
  const std::size_t longer = ellipse.half_axes[0] >= ellipse.half_axes[1] ? 0 : 1;
  const double a = ellipse.half_axes[longer], b = ellipse.half_axes[1 - longer];
  const Vector<2> folded = {std::abs(seen[longer]), std::abs(seen[1 - longer])};
  const auto nearest = nearest_point(a, b, folded);
  Vector<2> normal{};
  normal[longer] = std::copysign(nearest[0] / (a * a), seen[longer]);
  normal[1 - longer] = std::copysign(nearest[1] / (b * b), seen[1 - longer]);
  const bool is_inside = std::hypot(folded[0] / a, folded[1] / b) < 1.0;
  const double distance = norm(folded - nearest);
  return {is_inside ? -distance : distance, ellipse.pose.from_shape(normal / norm(normal))};
}

std::optional<Interval> chord(const EllipseOutline& ellipse, const GridLine<2>& line) noexcept {
  // In units of the half axes the ellipse is the unit circle.
  const auto in_half_axes = [&](const Vector<2>& vector) -> Vector<2> {
    const auto seen = ellipse.pose.to_shape(vector);
    return {seen[0] / ellipse.half_axes[0], seen[1] / ellipse.half_axes[1]};
  };
  Vector<2> unit{};
  unit[line.axis] = 1.0;
  const auto from_centre = in_half_axes(line.origin - ellipse.pose.centre()), along = in_half_axes(unit);
  const double square = dot(along, along), half = dot(from_centre, along);
  const double off = cross(from_centre, along);
  if (off * off >= square) return std::nullopt;
  const double root = std::sqrt(square - off * off);
  return Interval{(-half - root) / square, (-half + root) / square};
}

double area_in_square(const EllipseOutline& ellipse, const Vector<2>& corner) {
  std::array<Vector<2>, 4> corners = {{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}};
  for (auto& one : corners) {
    const auto seen = ellipse.pose.to_shape(corner + one - ellipse.pose.centre());
    one = {seen[0] / ellipse.half_axes[0], seen[1] / ellipse.half_axes[1]};
  }
  double area = 0.0;
  for (std::size_t i = 0; i < 4; ++i) area += area_of_triangle_in_unit_disc(corners[i], corners[(i + 1) % 4]);
  return std::clamp(area * ellipse.half_axes[0] * ellipse.half_axes[1], 0.0, 1.0);
}

}  // namespace breccia::gaps

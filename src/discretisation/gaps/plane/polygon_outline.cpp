#include "discretisation/gaps/plane/polygon_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

/// Calls action(begin, end) for all sides.
template <class Action>
void for_sides(const std::vector<Vector<2>>& corners, const Action& action) {
  for (std::size_t i = 0; i < corners.size(); ++i) action(corners[i], corners[(i + 1) % corners.size()]);
}

/// Cuts off what lies to the right of the line from one point to another.
std::vector<Vector<2>> left_of(const std::vector<Vector<2>>& corners, const Vector<2>& from, const Vector<2>& to) {
  const auto height = [&](const Vector<2>& point) { return cross(to - from, point - from); };
  std::vector<Vector<2>> rest;
  for_sides(corners, [&](const Vector<2>& begin, const Vector<2>& end) {
    const double at_begin = height(begin), at_end = height(end);
    if (at_begin >= 0.0) rest.push_back(begin);
    if ((at_begin >= 0.0) != (at_end >= 0.0)) rest.push_back(begin + at_begin / (at_begin - at_end) * (end - begin));
  });
  return rest;
}

double area_of(const std::vector<Vector<2>>& corners) {
  double twice = 0.0;
  for_sides(corners, [&](const Vector<2>& begin, const Vector<2>& end) { twice += cross(begin, end); });
  return 0.5 * twice;
}

}  // namespace

FromOutline from_outline(const PolygonOutline& polygon, const Vector<2>& point) noexcept {
  double highest = -std::numeric_limits<double>::infinity(), nearest = std::numeric_limits<double>::infinity();
  Vector<2> normal_of_highest{}, from_nearest{};
  for_sides(polygon.corners, [&](const Vector<2>& begin, const Vector<2>& end) {
    const auto along = end - begin, from_begin = point - begin;
    const double length = norm(along);
    if (length == 0.0) return;
    const double height = cross(from_begin, along) / length;
    if (height > highest) {
      highest = height;
      normal_of_highest = {along[1] / length, -along[0] / length};
    }
    const double place = std::clamp(dot(from_begin, along) / (length * length), 0.0, 1.0);
    const auto from_side = from_begin - place * along;
    if (norm(from_side) < nearest) {
      nearest = norm(from_side);
      from_nearest = from_side;
    }
  });
  constexpr double least = 1e-12;
  if (highest <= least || nearest <= least) return {highest, normal_of_highest};
  return {nearest, from_nearest / nearest};
}

std::optional<Interval> chord(const PolygonOutline& polygon, const GridLine<2>& line) noexcept {
  constexpr double on_line = 1e-9;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  const auto add = [&](const Vector<2>& point) {
    least = std::min(least, point[line.axis] - line.origin[line.axis]);
    most = std::max(most, point[line.axis] - line.origin[line.axis]);
  };
  const auto off = [&](const Vector<2>& point) { return point[1 - line.axis] - line.origin[1 - line.axis]; };
  for_sides(polygon.corners, [&](const Vector<2>& begin, const Vector<2>& end) {
    const double at_begin = off(begin), at_end = off(end);
    // A side on the line is a chord.
    if (std::abs(at_begin) < on_line) add(begin);
    if ((at_begin > 0.0) != (at_end > 0.0)) add(begin + at_begin / (at_begin - at_end) * (end - begin));
  });
  if (!(most > least)) return std::nullopt;
  return Interval{least, most};
}

double area_in_square(const PolygonOutline& polygon, const Vector<2>& corner) {
  const Vector<2> right = {1.0, 0.0}, up = {0.0, 1.0};
  // Relative to the corner, so that areas are differences of small numbers.
  std::vector<Vector<2>> rest;
  for (const auto& one : polygon.corners) rest.push_back(one - corner);
  rest = left_of(rest, {}, right);
  rest = left_of(rest, right, right + up);
  rest = left_of(rest, right + up, up);
  rest = left_of(rest, up, {});
  return std::clamp(area_of(rest), 0.0, 1.0);
}

}  // namespace breccia::gaps

#include "breccia/microstructure/convex_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/vector_algebra.hpp"

namespace breccia {
namespace {

/// The corner that follows another one.
const Vector<2>& after(std::span<const Vector<2>> corners, std::size_t corner) {
  return corners[(corner + 1) % corners.size()];
}

/// Twice the area between a corner, the next one and the origin, summed; positive if the corners go counter-clockwise.
double twice_signed_area(std::span<const Vector<2>> corners) noexcept {
  double sum = 0.0;
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    // Coordinates are relative to the first corner, which reduces roundoff.
    sum += cross(corners[corner] - corners[0], after(corners, corner) - corners[0]);
  }
  return sum;
}

/// The turn of the outline in each corner [rad], counter-clockwise.
std::vector<double> turns(std::span<const Vector<2>> corners) {
  std::vector<double> angles;
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    const auto& before = corners[(corner + corners.size() - 1) % corners.size()];
    const auto arriving = corners[corner] - before;
    const auto leaving = after(corners, corner) - corners[corner];
    angles.push_back(std::atan2(cross(arriving, leaving), dot(arriving, leaving)));
  }
  return angles;
}

std::vector<CornerMistake> inward_corners(std::span<const Vector<2>> corners) {
  constexpr double roundoff = 1e-9;  // turn of a corner on a straight side [rad]
  const double sense = twice_signed_area(corners) > 0.0 ? 1.0 : -1.0;
  std::vector<CornerMistake> mistakes;
  double all = 0.0;
  const auto angles = turns(corners);
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    all += sense * angles[corner];
    if (sense * angles[corner] < -roundoff) {
      mistakes.push_back({corner, "expected the corners of a convex polygon in order, but this one points inwards"});
    }
  }
  const bool winds_once = std::abs(all - 2.0 * std::numbers::pi) < 1.0;
  if (mistakes.empty() && !winds_once) {
    mistakes.push_back({0, "expected the corners of a convex polygon in order, but its sides cross"});
  }
  return mistakes;
}

std::vector<Vector<2>> sound(std::vector<Vector<2>> corners) {
  const auto mistakes = corner_mistakes(corners);
  if (mistakes.empty()) return corners;
  std::string message = "polygon:";
  for (const auto& [corner, text] : mistakes) message += fmt::format("\n  corner {}: {}", corner + 1, text);
  throw InputError(message);
}

std::vector<Vector<2>> centred(std::vector<Vector<2>> corners) {
  if (twice_signed_area(corners) < 0.0) std::ranges::reverse(corners);
  const auto centre = centroid(corners);
  // Corners that are centred already are not changed.
  constexpr double roundoff = 1e-14;
  const double size = norm(corners[1] - corners[0]);
  if (norm(centre) <= roundoff * size) return corners;
  for (auto& corner : corners) corner -= centre;
  return corners;
}

}  // namespace

std::vector<CornerMistake> corner_mistakes(std::span<const Vector<2>> corners) {
  std::vector<CornerMistake> mistakes;
  if (corners.size() < 3) {
    return {{0, fmt::format("expected three corners or more of a polygon, got {}", corners.size())}};
  }
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    const auto& [x, y] = corners[corner];
    if (!std::isfinite(x) || !std::isfinite(y)) {
      mistakes.push_back({corner, "expected finite coordinates"});
    } else if (corners[corner] == after(corners, corner)) {
      mistakes.push_back({corner, "expected corners in different places, but the next one is here, too"});
    }
  }
  if (mistakes.empty() && twice_signed_area(corners) == 0.0) {
    mistakes.push_back({0, "expected the corners of a polygon, but they lie on a line"});
  }
  return mistakes.empty() ? inward_corners(corners) : mistakes;
}

ConvexPolygon::ConvexPolygon(std::vector<Vector<2>> corners)
    : corners_(std::make_shared<const std::vector<Vector<2>>>(centred(sound(std::move(corners))))) {}

ConvexPolygon ConvexPolygon::scaled(double factor) const {
  auto corners = *corners_;
  for (auto& corner : corners) corner = {factor * corner[0], factor * corner[1]};
  return ConvexPolygon(std::move(corners));
}

SupportPoint ConvexPolygon::support(const Vector<2>& direction) const noexcept {
  const auto farthest =
      std::ranges::max_element(*corners_, {}, [&](const Vector<2>& corner) { return dot(direction, corner); });
  return {*farthest, 0.0};
}

double ConvexPolygon::height(const Vector<2>& point) const noexcept {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t corner = 0; corner < corners_->size(); ++corner) {
    const auto along = after(*corners_, corner) - (*corners_)[corner];
    smallest = std::min(smallest, cross(along, point - (*corners_)[corner]) / norm(along));
  }
  return smallest;
}

bool ConvexPolygon::contains(const Vector<2>& point) const noexcept {
  return height(point) >= 0.0;
}

double ConvexPolygon::depth(const Vector<2>& point) const noexcept {
  return std::max(0.0, height(point));
}

Vector<2> centroid(std::span<const Vector<2>> corners) noexcept {
  const auto& origin = corners.front();
  Vector<2> moment{};
  double twice_area = 0.0;
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    const auto here = corners[corner] - origin, next = after(corners, corner) - origin;
    const double triangle = cross(here, next);
    twice_area += triangle;
    moment += triangle * here;
    moment += triangle * next;
  }
  return origin + 1.0 / (3.0 * twice_area) * moment;
}

double area(const ConvexPolygon& polygon) noexcept {
  return 0.5 * twice_signed_area(polygon.corners());
}

double perimeter(const ConvexPolygon& polygon) noexcept {
  const auto corners = polygon.corners();
  double sum = 0.0;
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    sum += norm(after(corners, corner) - corners[corner]);
  }
  return sum;
}

double circumradius(const ConvexPolygon& polygon) noexcept {
  double largest = 0.0;
  for (const auto& corner : polygon.corners()) largest = std::max(largest, norm(corner));
  return largest;
}

}  // namespace breccia

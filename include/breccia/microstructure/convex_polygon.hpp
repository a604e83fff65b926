#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "breccia/microstructure/convex_outline.hpp"

namespace breccia {

/// A mistake in one corner of a polygon.
struct CornerMistake {
  std::size_t corner;  ///< number of the corner, from 0
  std::string text;
};

/// The reasons why these corners, in their order around the polygon in either direction, do not make a convex polygon:
/// fewer than three corners, a corner that is not finite, two corners at one point, a corner that points inwards, sides
/// that cross. Empty if the polygon is convex.
[[nodiscard]] std::vector<CornerMistake> corner_mistakes(std::span<const Vector<2>> corners);

/// A convex polygon with its centroid in the origin. Copies share their corners.
class ConvexPolygon {
 public:
  /// Takes the corners [m] in their order around the polygon, in either direction, and moves them so that the centroid
  /// is the origin. Throws InputError with the list of corner_mistakes().
  explicit ConvexPolygon(std::vector<Vector<2>> corners);

  [[nodiscard]] std::span<const Vector<2>> corners() const noexcept { return *corners_; }  ///< counter-clockwise [m]
  /// The polygon with all lengths multiplied by a factor.
  [[nodiscard]] ConvexPolygon scaled(double factor) const;

  /// The point of the polygon that lies farthest along a direction, which has length 1.
  [[nodiscard]] SupportPoint support(const Vector<2>& direction) const noexcept;
  /// Whether a point is inside the polygon or on its outline.
  [[nodiscard]] bool contains(const Vector<2>& point) const noexcept;
  /// Distance from a point inside to the outline [m]; 0 on it.
  [[nodiscard]] double depth(const Vector<2>& point) const noexcept;

  friend bool operator==(const ConvexPolygon& one, const ConvexPolygon& other) {
    return *one.corners_ == *other.corners_;
  }

 private:
  /// Smallest distance of a point from the lines of the sides [m]; positive inside the polygon, negative outside.
  [[nodiscard]] double height(const Vector<2>& point) const noexcept;

  std::shared_ptr<const std::vector<Vector<2>>> corners_;
};

/// The centroid of a polygon with these corners [m], in their order around it.
[[nodiscard]] Vector<2> centroid(std::span<const Vector<2>> corners) noexcept;

[[nodiscard]] double area(const ConvexPolygon& polygon) noexcept;          ///< [m^2]
[[nodiscard]] double perimeter(const ConvexPolygon& polygon) noexcept;     ///< [m]
[[nodiscard]] double circumradius(const ConvexPolygon& polygon) noexcept;  ///< largest distance from the centroid [m]

}  // namespace breccia

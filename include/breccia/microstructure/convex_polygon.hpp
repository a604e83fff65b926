#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "breccia/microstructure/convex_outline.hpp"

namespace breccia {

/// A mistake of one corner of a polygon.
struct CornerMistake {
  std::size_t corner;  ///< its number, from 0
  std::string text;
};

/// The mistakes that keep corners, in their order around the polygon either way, from making a convex polygon: fewer
/// than three corners, one that is not finite, two at one point, one that points inwards, sides that cross. Empty if
/// there are none.
[[nodiscard]] std::vector<CornerMistake> corner_mistakes(std::span<const Vector<2>> corners);

/// A convex polygon with its centroid in the origin. Copies share their corners.
class ConvexPolygon {
 public:
  /// Corners [m] in their order around the polygon, either way; they are moved so that the centroid is the origin.
  /// Throws InputError that lists corner_mistakes().
  explicit ConvexPolygon(std::vector<Vector<2>> corners);

  [[nodiscard]] std::span<const Vector<2>> corners() const noexcept { return *corners_; }  ///< counter-clockwise [m]
  /// The polygon with all lengths multiplied by a factor.
  [[nodiscard]] ConvexPolygon scaled(double factor) const;

  /// The point farthest along a direction of length 1.
  [[nodiscard]] SupportPoint support(const Vector<2>& direction) const noexcept;
  /// True for points inside and on the outline.
  [[nodiscard]] bool contains(const Vector<2>& point) const noexcept;
  /// Distance from a point inside to the outline [m]; 0 on it.
  [[nodiscard]] double depth(const Vector<2>& point) const noexcept;

  friend bool operator==(const ConvexPolygon& one, const ConvexPolygon& other) {
    return *one.corners_ == *other.corners_;
  }

 private:
  /// Smallest distance of a point from the lines of the sides [m], counted inwards: negative outside.
  [[nodiscard]] double height(const Vector<2>& point) const noexcept;

  std::shared_ptr<const std::vector<Vector<2>>> corners_;
};

/// The centroid of a polygon with these corners [m], in their order around it.
[[nodiscard]] Vector<2> centroid(std::span<const Vector<2>> corners) noexcept;

[[nodiscard]] double area(const ConvexPolygon& polygon) noexcept;          ///< [m^2]
[[nodiscard]] double perimeter(const ConvexPolygon& polygon) noexcept;     ///< [m]
[[nodiscard]] double circumradius(const ConvexPolygon& polygon) noexcept;  ///< largest distance from the centroid [m]

}  // namespace breccia

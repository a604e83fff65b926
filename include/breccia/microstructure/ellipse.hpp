#pragma once

#include "breccia/microstructure/convex_outline.hpp"

namespace breccia {

/// An ellipse with its axes along x and y, around the origin.
struct Ellipse {
  Vector<2> axes;  ///< whole lengths of the axes [m]

  /// The point of the ellipse that lies farthest along a direction, which has length 1.
  [[nodiscard]] SupportPoint support(const Vector<2>& direction) const noexcept;
  /// Whether a point is inside the ellipse or on its outline.
  [[nodiscard]] bool contains(const Vector<2>& point) const noexcept;
  /// A lower bound of the distance from a point inside to the outline [m]; 0 on it.
  [[nodiscard]] double depth(const Vector<2>& point) const noexcept;

  friend bool operator==(const Ellipse&, const Ellipse&) = default;
};

[[nodiscard]] double area(const Ellipse& ellipse) noexcept;          ///< [m^2]
[[nodiscard]] double perimeter(const Ellipse& ellipse);              ///< [m]
[[nodiscard]] double circumradius(const Ellipse& ellipse) noexcept;  ///< largest distance from the centre [m]

}  // namespace breccia

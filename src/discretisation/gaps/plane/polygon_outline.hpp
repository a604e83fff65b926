#pragma once

#include <optional>
#include <vector>

#include "discretisation/gaps/line.hpp"
#include "discretisation/gaps/plane/from_outline.hpp"

namespace breccia::gaps {

/// The outline of a convex polygon, by its corners, counter-clockwise.
struct PolygonOutline {
  std::vector<Vector<2>> corners;
};

[[nodiscard]] FromOutline from_outline(const PolygonOutline& polygon, const Vector<2>& point) noexcept;
/// The piece of a line inside.
[[nodiscard]] std::optional<Interval> chord(const PolygonOutline& polygon, const GridLine<2>& line) noexcept;
/// Area inside of the square of side 1 with this lower left corner, exact to rounding.
[[nodiscard]] double area_in_square(const PolygonOutline& polygon, const Vector<2>& corner);

}  // namespace breccia::gaps

#pragma once

#include <optional>

#include "breccia/microstructure/particle.hpp"

#include "discretisation/gaps/line.hpp"
#include "discretisation/gaps/plane/from_outline.hpp"

namespace breccia::gaps {

/// The outline of an ellipse.
struct EllipseOutline {
  Vector<2> half_axes;
  Pose pose;
};

[[nodiscard]] FromOutline from_outline(const EllipseOutline& ellipse, const Vector<2>& point) noexcept;
/// The piece of a line inside.
[[nodiscard]] std::optional<Interval> chord(const EllipseOutline& ellipse, const GridLine<2>& line) noexcept;
/// Area inside of the square of side 1 with this lower left corner, exact to rounding.
[[nodiscard]] double area_in_square(const EllipseOutline& ellipse, const Vector<2>& corner);

}  // namespace breccia::gaps

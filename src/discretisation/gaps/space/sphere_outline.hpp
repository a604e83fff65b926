#pragma once

#include <optional>

#include "breccia/microstructure/ball.hpp"

#include "discretisation/gaps/line.hpp"

namespace breccia::gaps {

/// The surface of a sphere, or of the layer around one, in units of the cell side.
class SphereOutline {
 public:
  /// The surface `layer` [m] outside a sphere [m]; lengths are multiplied by a factor [1/m].
  SphereOutline(const Sphere& sphere, double layer, double factor);

  [[nodiscard]] const Vector<3>& centre() const noexcept { return sphere_.centre; }
  /// The largest distance from the centre.
  [[nodiscard]] double reach() const noexcept { return 0.5 * sphere_.diameter; }
  [[nodiscard]] SphereOutline moved(const Vector<3>& by) const;

  /// Distance of a point, negative inside.
  [[nodiscard]] double distance(const Vector<3>& point) const;
  /// The gradient of the distance; zero in the centre.
  [[nodiscard]] Vector<3> normal(const Vector<3>& point) const;
  /// The piece of a line inside.
  [[nodiscard]] std::optional<Interval> chord(const GridLine<3>& line) const;
  /// Volume inside of the cell of side 1 with this lowest corner, exact to rounding.
  [[nodiscard]] double content_of_cell(const Vector<3>& corner) const;

 private:
  Sphere sphere_;
};

}  // namespace breccia::gaps

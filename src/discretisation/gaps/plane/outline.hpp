#pragma once

#include <optional>
#include <variant>

#include "breccia/microstructure/ball.hpp"
#include "breccia/microstructure/particle.hpp"

#include "discretisation/gaps/line.hpp"
#include "discretisation/gaps/plane/ellipse_outline.hpp"
#include "discretisation/gaps/plane/polygon_outline.hpp"

namespace breccia::gaps {

[[nodiscard]] FromOutline from_outline(const Disc& disc, const Vector<2>& point) noexcept;
/// The piece of a line inside.
[[nodiscard]] std::optional<Interval> chord(const Disc& disc, const GridLine<2>& line) noexcept;
/// Area inside of the square of side 1 with this lower left corner, exact to rounding.
[[nodiscard]] double area_in_square(const Disc& disc, const Vector<2>& corner);

/// The outline of a convex particle, or of the layer around one, in units of the cell side.
class Outline {
 public:
  /// The outline of a particle, `layer` [m] outside it; lengths are multiplied by a factor [1/m].
  Outline(const Particle& particle, double layer, double factor);

  [[nodiscard]] const Vector<2>& centre() const noexcept { return centre_; }
  /// The largest distance from the centre.
  [[nodiscard]] double reach() const noexcept { return reach_; }
  [[nodiscard]] Outline moved(const Vector<2>& by) const;

  /// Distance of a point, negative inside.
  [[nodiscard]] double distance(const Vector<2>& point) const { return from(point).distance - layer_; }
  /// The gradient of the distance; zero where there is none, as in the centre of a disc.
  [[nodiscard]] Vector<2> normal(const Vector<2>& point) const { return from(point).normal; }
  /// The piece of a line inside.
  [[nodiscard]] std::optional<Interval> chord(const GridLine<2>& line) const;
  /// Area inside of the square of side 1 with this lower left corner: exact to rounding for particles and discs with
  /// layers, to some 1e-5 of the area for other layers.
  [[nodiscard]] double content_of_cell(const Vector<2>& corner) const;

 private:
  [[nodiscard]] FromOutline from(const Vector<2>& point) const;

  Vector<2> centre_;
  double reach_;
  double layer_;  ///< width of the layer; 0 around a disc, which has it in its diameter
  std::variant<Disc, EllipseOutline, PolygonOutline> particle_;
  PolygonOutline with_layer_;  ///< the outline of the layer, as a polygon; empty without a layer
};

}  // namespace breccia::gaps

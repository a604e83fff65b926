#pragma once

#include <array>
#include <limits>
#include <string>
#include <variant>

#include "breccia/microstructure/convex_polygon.hpp"
#include "breccia/microstructure/ellipse.hpp"

namespace breccia {

/// A convex shape around the origin.
using Shape = std::variant<Ellipse, ConvexPolygon>;

/// Centre and orientation of a particle.
class Pose {
 public:
  /// `centre` [m]; `angle` from the x axis to the first axis of the shape, counter-clockwise [rad].
  Pose(const Vector<2>& centre, double angle) noexcept;

  [[nodiscard]] const Vector<2>& centre() const noexcept { return centre_; }
  [[nodiscard]] double angle() const noexcept { return angle_; }
  /// The pose with this orientation and another centre [m].
  [[nodiscard]] Pose at(const Vector<2>& centre) const noexcept;

  /// A direction of the box in the coordinates of the shape.
  [[nodiscard]] Vector<2> to_shape(const Vector<2>& direction) const noexcept {
    return {cosine_ * direction[0] + sine_ * direction[1], cosine_ * direction[1] - sine_ * direction[0]};
  }
  /// A direction of the shape in the coordinates of the box.
  [[nodiscard]] Vector<2> from_shape(const Vector<2>& direction) const noexcept {
    return {cosine_ * direction[0] - sine_ * direction[1], cosine_ * direction[1] + sine_ * direction[0]};
  }

  friend bool operator==(const Pose&, const Pose&) = default;

 private:
  Vector<2> centre_;
  double angle_, cosine_, sine_;
};

/// A convex particle.
struct Particle {
  Shape shape;
  Pose pose;

  friend bool operator==(const Particle&, const Particle&) = default;
};

[[nodiscard]] double area(const Shape& shape);          ///< [m^2]
[[nodiscard]] double perimeter(const Shape& shape);     ///< [m]
[[nodiscard]] double circumradius(const Shape& shape);  ///< largest distance from the centre [m]
/// Diameter of the disc of the same area [m].
[[nodiscard]] double equivalent_diameter(const Shape& shape);
/// A description of the shape: "ellipse of 2 um x 1 um", "polygon of 6 corners".
[[nodiscard]] std::string in_words(const Shape& shape);

/// The largest distances of a shape in this orientation from its centre along each axis: {{left, right}, {below,
/// above}}, all positive [m].
[[nodiscard]] std::array<Vector<2>, 2> extent(const Shape& shape, const Pose& pose);

/// Distance of a point from the outline of a particle [m], exact to rounding outside. Inside it is negative, and its
/// magnitude is a lower bound of the distance.
[[nodiscard]] double signed_distance(const Particle& particle, const Vector<2>& point);

/// The gap between two shapes, and its direction.
struct ParticleGap {
  double width;         ///< width of the gap [m]
  Vector<2> direction;  ///< direction from the first shape to the second, of length 1
};

/// Distance between the outlines of two particles (theory, Eq. 52): never above the true distance, and at most 1e-13 of
/// the distance between the centres below it. A gap of `enough` [m] or more is not computed to this accuracy: its width
/// is then a lower bound. The width is negative where the particles overlap: a displacement of the second particle by
/// its magnitude along the direction ends the overlap. The shortest displacement that does so is no longer, and not
/// much shorter where `enough` is infinite.
[[nodiscard]] ParticleGap gap(const Shape& one, const Pose& at_one, const Shape& other, const Pose& at_other,
                              double enough = std::numeric_limits<double>::infinity());

}  // namespace breccia

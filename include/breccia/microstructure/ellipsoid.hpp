#pragma once

#include <array>

#include "breccia/microstructure/vector.hpp"

namespace breccia {

/// Orientation of a body: the directions of its three axes, of length 1 and perpendicular to each other.
using AxisDirections = std::array<Vector<3>, 3>;

/// The orientation of a body whose axes lie along x, y and z.
inline constexpr AxisDirections unturned = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

/// The orientation of a body after a rotation from axes along x, y and z. The rotation is a quaternion of any length
/// but 0, its scalar part first; four numbers from a normal distribution make all rotations equally likely.
[[nodiscard]] AxisDirections turned(const std::array<double, 4>& quaternion);

/// Orientation of a body by three angles [rad]: its first axis has the `azimuth` from x in the xy plane and the
/// `elevation` above this plane, and the body is turned by `roll` about it. Without a roll the second axis is in the xy
/// plane.
struct Turn {
  double azimuth = 0.0;
  double elevation = 0.0;
  double roll = 0.0;
};

/// The orientation of a body with these angles.
[[nodiscard]] AxisDirections turned(const Turn& turn);
/// The angles of an orientation whose axes form a right-handed system.
[[nodiscard]] Turn turn_of(const AxisDirections& directions);

/// An ellipsoid in a box. With two equal axes it is one of revolution.
struct Ellipsoid {
  Vector<3> centre{};                    ///< [m]
  Vector<3> axes{};                      ///< whole lengths of the axes [m]
  AxisDirections directions = unturned;  ///< directions of the axes

  /// Whether a point is inside the ellipsoid or on its surface.
  [[nodiscard]] bool contains(const Vector<3>& point) const noexcept;

  friend bool operator==(const Ellipsoid&, const Ellipsoid&) = default;
};

[[nodiscard]] double volume(const Ellipsoid& ellipsoid) noexcept;  ///< [m^3]
[[nodiscard]] double surface(const Ellipsoid& ellipsoid);  ///< surface area, with a relative error of 1e-12 [m^2]
/// Mean over all directions of the width of the ellipsoid, the distance between the two parallel planes that touch it
/// [m].
[[nodiscard]] double mean_width(const Ellipsoid& ellipsoid);
/// Diameter of the ball of the same volume [m].
[[nodiscard]] double equivalent_diameter(const Ellipsoid& ellipsoid) noexcept;
[[nodiscard]] double circumradius(const Ellipsoid& ellipsoid) noexcept;  ///< largest distance from the centre [m]

/// Volume of a coating, that is, of the points outside the ellipsoid that are no farther from it than `thickness` [m^3]
/// (theory, Eq. 52a).
[[nodiscard]] double coating_volume(const Ellipsoid& ellipsoid, double thickness);

/// The largest distance of its points from its centre along x, y and z, which is equal in both directions of an axis
/// [m].
[[nodiscard]] Vector<3> extent(const Ellipsoid& ellipsoid) noexcept;

/// Distance of a point from the surface [m], negative inside; exact to rounding.
[[nodiscard]] double signed_distance(const Ellipsoid& ellipsoid, const Vector<3>& point);

/// Distance between the surfaces of two ellipsoids [m] (theory, Eq. 52): never above the true distance, and at most
/// 1e-13 of the distance between the centres below it. It is negative where they overlap: its magnitude is then the
/// length of a displacement of the second ellipsoid that ends the overlap.
[[nodiscard]] double gap(const Ellipsoid& one, const Ellipsoid& other);

}  // namespace breccia

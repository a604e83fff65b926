#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "breccia/microstructure/random_sequential.hpp"

namespace breccia {

// The functions for particles that a sequential packing calls, overloaded for particles in a plane and for ellipsoids.
// `random()` returns numbers uniform in [0, 1).

[[nodiscard]] double size_of(const ParticleToPlace& particle);    ///< area [m^2]
[[nodiscard]] double size_of(const EllipsoidToPlace& particle);   ///< volume [m^3]
[[nodiscard]] double reach_of(const ParticleToPlace& particle);   ///< largest distance from the centre [m]
[[nodiscard]] double reach_of(const EllipsoidToPlace& particle);  ///< largest distance from the centre [m]
/// Area or volume of a particle with the shell around it [m^dim].
[[nodiscard]] double size_with_shell(const ParticleToPlace& particle);
[[nodiscard]] double size_with_shell(const EllipsoidToPlace& particle);
/// The least width of a particle along the axes of the box over all orientations [m]; for a particle in a plane over
/// orientations in steps of two degrees.
[[nodiscard]] double least_width(const ParticleToPlace& particle);
[[nodiscard]] double least_width(const EllipsoidToPlace& particle);
[[nodiscard]] bool has_finite_angle(const ParticleToPlace& particle);
[[nodiscard]] bool has_finite_angle(const EllipsoidToPlace& particle);
[[nodiscard]] std::string description_of(const ParticleToPlace& particle);
[[nodiscard]] std::string description_of(const EllipsoidToPlace& particle);

[[nodiscard]] inline const Vector<2>& centre_of(const Pose& pose) {
  return pose.centre();
}
[[nodiscard]] inline const Vector<3>& centre_of(const EllipsoidPose& pose) {
  return pose.centre;
}
/// The pose with this orientation and another centre [m].
[[nodiscard]] inline Pose moved_to(const Pose& pose, const Vector<2>& centre) {
  return pose.at(centre);
}
[[nodiscard]] inline EllipsoidPose moved_to(const EllipsoidPose& pose, const Vector<3>& centre) {
  return {centre, pose.quaternion};
}

/// The largest distances of a particle from its centre down and up along each axis, all positive [m].
[[nodiscard]] std::array<Vector<2>, 2> reach_along_axes(const ParticleToPlace& particle, const Pose& pose);
[[nodiscard]] std::array<Vector<2>, 3> reach_along_axes(const EllipsoidToPlace& particle, const EllipsoidPose& pose);

/// Distance between two particles [m], negative where they overlap; above `enough` the value is a lower bound.
[[nodiscard]] double gap_between(const ParticleToPlace& one, const Pose& at_one, const ParticleToPlace& other,
                                 const Pose& at_other, double enough);
[[nodiscard]] double gap_between(const EllipsoidToPlace& one, const EllipsoidPose& at_one,
                                 const EllipsoidToPlace& other, const EllipsoidPose& at_other, double enough);

/// The product of two rotations (quaternions): the second one is applied first.
[[nodiscard]] std::array<double, 4> product(const std::array<double, 4>& one, const std::array<double, 4>& other);

/// A pose with a random orientation.
template <class Random>
[[nodiscard]] Pose posed_at_random(const ParticleToPlace& particle, const Vector<2>& centre, Random&& random) {
  const double angle = 2.0 * std::numbers::pi * random();
  return {centre, particle.angle.value_or(angle)};
}

/// A pose with a random rotation, all equally likely (Shoemake, Graphics Gems III, 1992, p. 124).
template <class Random>
[[nodiscard]] EllipsoidPose posed_at_random(const EllipsoidToPlace&, const Vector<3>& centre, Random&& random) {
  const double share = random(), first = 2.0 * std::numbers::pi * random(), second = 2.0 * std::numbers::pi * random();
  const double one = std::sqrt(1.0 - share), other = std::sqrt(share);
  return {centre, {other * std::cos(second), one * std::sin(first), one * std::cos(first), other * std::sin(second)}};
}

/// A pose with another centre, turned by at most about `step` [rad].
template <class Random>
[[nodiscard]] Pose turned_a_little(const ParticleToPlace& particle, const Pose& pose, const Vector<2>& centre,
                                   double step, Random&& random) {
  const double turn = step * (2.0 * random() - 1.0);
  return {centre, particle.angle.value_or(pose.angle() + turn)};
}

template <class Random>
[[nodiscard]] EllipsoidPose turned_a_little(const EllipsoidToPlace&, const EllipsoidPose& pose, const Vector<3>& centre,
                                            double step, Random&& random) {
  std::array<double, 4> turn = {1.0, 0.0, 0.0, 0.0};
  for (std::size_t axis = 1; axis < turn.size(); ++axis) turn[axis] = 0.5 * step * (2.0 * random() - 1.0);
  return {centre, product(turn, pose.quaternion)};
}

}  // namespace breccia

#include "microstructure/shapes/particles_to_place.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/microstructure/ellipsoid.hpp"

namespace breccia {
namespace {

Ellipsoid posed(const EllipsoidToPlace& particle, const EllipsoidPose& pose) {
  return {pose.centre, particle.axes, turned(pose.quaternion)};
}

}  // namespace

double size_of(const ParticleToPlace& particle) {
  return area(particle.shape);
}

double size_of(const EllipsoidToPlace& particle) {
  return volume(Ellipsoid{{}, particle.axes});
}

double reach_of(const ParticleToPlace& particle) {
  return circumradius(particle.shape);
}

double reach_of(const EllipsoidToPlace& particle) {
  return 0.5 * std::ranges::max(particle.axes);
}

double size_with_shell(const ParticleToPlace& particle) {
  const double shell = particle.shell;
  return area(particle.shape) + shell * perimeter(particle.shape) + std::numbers::pi * shell * shell;
}

double size_with_shell(const EllipsoidToPlace& particle) {
  const Ellipsoid ellipsoid = {{}, particle.axes};
  return volume(ellipsoid) + coating_volume(ellipsoid, particle.shell);
}

double least_width(const ParticleToPlace& particle) {
  const auto width_at = [&particle](double angle) {
    const auto reach = extent(particle.shape, Pose({0.0, 0.0}, angle));
    return std::max(reach[0][0] + reach[0][1], reach[1][0] + reach[1][1]);
  };
  if (particle.angle) return width_at(*particle.angle);
  constexpr int angles = 180;
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step < angles; ++step) {
    least = std::min(least, width_at(2.0 * std::numbers::pi * step / angles));
  }
  return least;
}

// The squares of the widths along three perpendicular axes add up to those of the axes of the ellipsoid; turned
// suitably, its widths are equal.
double least_width(const EllipsoidToPlace& particle) {
  const auto& [a, b, c] = particle.axes;
  return std::sqrt((a * a + b * b + c * c) / 3.0);
}

bool has_finite_angle(const ParticleToPlace& particle) {
  return std::isfinite(particle.angle.value_or(0.0));
}

bool has_finite_angle(const EllipsoidToPlace&) {
  return true;
}

std::string description_of(const ParticleToPlace& particle) {
  return in_words(particle.shape);
}

std::string description_of(const EllipsoidToPlace& particle) {
  return fmt::format("ellipsoid of {:.6g} m", fmt::join(particle.axes, " m x "));
}

std::array<Vector<2>, 2> reach_along_axes(const ParticleToPlace& particle, const Pose& pose) {
  return extent(particle.shape, pose);
}

std::array<Vector<2>, 3> reach_along_axes(const EllipsoidToPlace& particle, const EllipsoidPose& pose) {
  const auto [x, y, z] = extent(posed(particle, pose));
  return {{{x, x}, {y, y}, {z, z}}};
}

double gap_between(const ParticleToPlace& one, const Pose& at_one, const ParticleToPlace& other, const Pose& at_other,
                   double enough) {
  return gap(one.shape, at_one, other.shape, at_other, enough).width;
}

double gap_between(const EllipsoidToPlace& one, const EllipsoidPose& at_one, const EllipsoidToPlace& other,
                   const EllipsoidPose& at_other, double) {
  return gap(posed(one, at_one), posed(other, at_other));
}

std::array<double, 4> product(const std::array<double, 4>& one, const std::array<double, 4>& other) {
  const auto& [w, x, y, z] = one;
  const auto& [a, b, c, d] = other;
  std::array<double, 4> both = {w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c,
                                w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a};
  const double length = std::sqrt(both[0] * both[0] + both[1] * both[1] + both[2] * both[2] + both[3] * both[3]);
  for (double& part : both) part /= length;
  return both;
}

}  // namespace breccia

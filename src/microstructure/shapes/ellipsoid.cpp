#include "breccia/microstructure/ellipsoid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Dense>

#include "microstructure/vector_algebra.hpp"

namespace breccia {
namespace {

Eigen::Vector3d eigen(const Vector<3>& vector) {
  return {vector[0], vector[1], vector[2]};
}

/// The matrix Q of the ellipsoid x . Q^-1 x = 1 around the origin; the support function is h(n) = sqrt(n . Q n).
Eigen::Matrix3d squared_half_axes(const Ellipsoid& ellipsoid) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto direction = eigen(ellipsoid.directions[axis]);
    sum += 0.25 * ellipsoid.axes[axis] * ellipsoid.axes[axis] * direction * direction.transpose();
  }
  return sum;
}

/// The coordinates of a point along the axes of an ellipsoid, relative to its centre [m].
Vector<3> seen_along_axes(const Ellipsoid& ellipsoid, const Vector<3>& point) {
  const auto apart = point - ellipsoid.centre;
  return {dot(ellipsoid.directions[0], apart), dot(ellipsoid.directions[1], apart),
          dot(ellipsoid.directions[2], apart)};
}

/// The separation of two ellipsoids with the vector `apart` between their centres: the maximum over all directions n of
/// the gap s(n) = n . apart - h_one(n) - h_other(n) between their planes of support (theory, Eq. 52).
class EllipsoidSeparation {
 public:
  EllipsoidSeparation(const Ellipsoid& one, const Ellipsoid& other)
      : apart_(eigen(other.centre - one.centre)), one_(squared_half_axes(one)), other_(squared_half_axes(other)) {}

  [[nodiscard]] double distance() const {
    if (apart_.squaredNorm() == 0.0) return -std::sqrt(one_(0, 0)) - std::sqrt(other_(0, 0));
    Eigen::Vector3d direction = normal_of_contact();
    double best = gap_along(direction);
    if (best <= 0.0) return best;
    // Where s is positive it has one maximum on the sphere of directions: Newton's method finds it from any direction.
    constexpr int most_steps = 50;
    for (int step = 0; step < most_steps; ++step) {
      const Eigen::Vector3d change = newton_step(direction, best);
      double factor = 1.0, next = best;
      Eigen::Vector3d trial = direction;
      for (; factor > 1e-4 && next <= best; factor *= 0.5) {
        trial = (direction + factor * change).normalized();
        next = gap_along(trial);
      }
      if (next <= best) break;
      direction = trial;
      best = next;
    }
    return best;
  }

 private:
  [[nodiscard]] double gap_along(const Eigen::Vector3d& direction) const {
    return direction.dot(apart_) - std::sqrt(direction.dot(one_ * direction)) -
           std::sqrt(direction.dot(other_ * direction));
  }

  /// The normal at the point where the ellipsoids touch when both are scaled by the same factor (Perram and Wertheim,
  /// Journal of Computational Physics 58 (1985) 409). Along it s has the sign of the distance.
  [[nodiscard]] Eigen::Vector3d normal_of_contact() const {
    constexpr int halvings = 50;
    double low = 0.0, high = 1.0;
    Eigen::Vector3d normal = apart_;
    for (int count = 0; count < halvings; ++count) {
      const double share = 0.5 * (low + high);
      normal = ((1.0 - share) * one_ + share * other_).inverse() * apart_;
      const double slope =
          (1.0 - share) * (1.0 - share) * normal.dot(one_ * normal) - share * share * normal.dot(other_ * normal);
      (slope > 0.0 ? low : high) = share;
    }
    return normal.normalized();
  }

  /// A step of Newton's method, tangent to the sphere of directions.
  [[nodiscard]] Eigen::Vector3d newton_step(const Eigen::Vector3d& direction, double present) const {
    Eigen::Vector3d gradient = apart_;
    Eigen::Matrix3d curvature = present * Eigen::Matrix3d::Identity();
    for (const Eigen::Matrix3d* body : {&one_, &other_}) {
      const Eigen::Vector3d product = *body * direction;
      const double height = std::sqrt(direction.dot(product));
      gradient -= product / height;
      curvature += *body / height - product * product.transpose() / (height * height * height);
    }
    const Eigen::Vector3d first = direction.unitOrthogonal(), second = direction.cross(first);
    Eigen::Matrix<double, 3, 2> tangents;
    tangents << first, second;
    const Eigen::Matrix2d reduced = tangents.transpose() * curvature * tangents;
    return tangents * (reduced.inverse() * (tangents.transpose() * gradient));
  }

  Eigen::Vector3d apart_;
  Eigen::Matrix3d one_, other_;
};

/// The point of an ellipsoid with half axes a that is nearest to y is a^2 y / (s + a^2 - c^2), where c is the shortest
/// half axis. Returns s, the root of sum of (a y / (s + a^2 - c^2))^2 = 1; 0 where there is none above 0. No coordinate
/// of y is negative.
double nearest_parameter(const Vector<3>& half_axes, const Vector<3>& y) {
  const double shortest = std::ranges::min(half_axes);
  const auto offset = [&](std::size_t axis) { return (half_axes[axis] - shortest) * (half_axes[axis] + shortest); };
  double s = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) s = std::max(s, half_axes[axis] * y[axis] - offset(axis));
  // The sum falls and is convex, and is 1 or more at this s unless the root is below: Newton's method only rises.
  constexpr int most_steps = 200;
  for (int step = 0; step < most_steps && s > 0.0; ++step) {
    double excess = -1.0, slope = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double share = half_axes[axis] * y[axis] / (s + offset(axis));
      excess += share * share;
      slope -= 2.0 * share * share / (s + offset(axis));
    }
    const double next = s - excess / slope;
    if (!(next > s)) break;
    s = next;
  }
  return s;
}

}  // namespace

AxisDirections turned(const std::array<double, 4>& quaternion) {
  const auto& [w, x, y, z] = quaternion;
  const Eigen::Matrix3d rotation = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
  AxisDirections directions{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t row = 0; row < 3; ++row) {
      directions[axis][row] = rotation(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(axis));
    }
  }
  return directions;
}

AxisDirections turned(const Turn& turn) {
  const double ca = std::cos(turn.azimuth), sa = std::sin(turn.azimuth);
  const double ce = std::cos(turn.elevation), se = std::sin(turn.elevation);
  const double cr = std::cos(turn.roll), sr = std::sin(turn.roll);
  const Vector<3> first = {ce * ca, ce * sa, se}, level = {-sa, ca, 0.0}, upright = {-se * ca, -se * sa, ce};
  AxisDirections directions = {first, {}, {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    directions[1][axis] = cr * level[axis] + sr * upright[axis];
    directions[2][axis] = cr * upright[axis] - sr * level[axis];
  }
  return directions;
}

Turn turn_of(const AxisDirections& directions) {
  const auto& [first, second, third] = directions;
  const double level = std::hypot(first[0], first[1]);
  // For a first axis along z the azimuth is arbitrary; 0 is taken.
  if (level == 0.0) return {0.0, std::atan2(first[2], 0.0), std::atan2(-third[1], second[1])};
  return {std::atan2(first[1], first[0]), std::atan2(first[2], level), std::atan2(second[2], third[2])};
}

bool Ellipsoid::contains(const Vector<3>& point) const noexcept {
  const auto y = seen_along_axes(*this, point);
  double square = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) square += 4.0 * y[axis] * y[axis] / (axes[axis] * axes[axis]);
  return square <= 1.0;
}

double volume(const Ellipsoid& ellipsoid) noexcept {
  return std::numbers::pi / 6.0 * ellipsoid.axes[0] * ellipsoid.axes[1] * ellipsoid.axes[2];
}

// Legendre's formula; see NIST Digital Library of Mathematical Functions, section 19.33.
double surface(const Ellipsoid& ellipsoid) {
  auto half = ellipsoid.axes;
  for (double& axis : half) axis *= 0.5;
  std::ranges::sort(half, std::greater{});
  const auto& [a, b, c] = half;
  if (a == c) return 4.0 * std::numbers::pi * a * a;
  const double sine_square = (a - c) * (a + c) / (a * a);
  const double sine = std::sqrt(sine_square), angle = std::atan2(sine, c / a);
  const double modulus = std::min(1.0, a / b * std::sqrt((b - c) * (b + c) / ((a - c) * (a + c))));
  return 2.0 * std::numbers::pi *
         (c * c +
          a * b / sine *
              (std::ellint_2(modulus, angle) * sine_square + std::ellint_1(modulus, angle) * (c / a) * (c / a)));
}

// The support function of an ellipsoid, integrated over all directions, is the product of its half axes times the
// surface of the ellipsoid with the reciprocal half axes.
double mean_width(const Ellipsoid& ellipsoid) {
  constexpr double square_of_two = 4.0;
  const auto& [a, b, c] = ellipsoid.axes;
  const double size = std::cbrt(a * b * c);
  Ellipsoid reciprocal = ellipsoid;
  for (double& axis : reciprocal.axes) axis = square_of_two * size / axis;
  return size / (16.0 * std::numbers::pi) * surface(reciprocal);
}

double equivalent_diameter(const Ellipsoid& ellipsoid) noexcept {
  return std::cbrt(ellipsoid.axes[0] * ellipsoid.axes[1] * ellipsoid.axes[2]);
}

double coating_volume(const Ellipsoid& ellipsoid, double thickness) {
  if (thickness == 0.0) return 0.0;
  return thickness * (surface(ellipsoid) + thickness * (2.0 * std::numbers::pi * mean_width(ellipsoid) +
                                                        4.0 / 3.0 * std::numbers::pi * thickness));
}

double circumradius(const Ellipsoid& ellipsoid) noexcept {
  return 0.5 * std::ranges::max(ellipsoid.axes);
}

Vector<3> extent(const Ellipsoid& ellipsoid) noexcept {
  Vector<3> reach{};
  for (std::size_t along = 0; along < 3; ++along) {
    double square = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double part = 0.5 * ellipsoid.axes[axis] * ellipsoid.directions[axis][along];
      square += part * part;
    }
    reach[along] = std::sqrt(square);
  }
  return reach;
}

double signed_distance(const Ellipsoid& ellipsoid, const Vector<3>& point) {
  auto y = seen_along_axes(ellipsoid, point);
  Vector<3> half_axes{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    y[axis] = std::abs(y[axis]);
    half_axes[axis] = 0.5 * ellipsoid.axes[axis];
  }
  const double s = nearest_parameter(half_axes, y);
  const auto shortest = static_cast<std::size_t>(std::ranges::min_element(half_axes) - half_axes.begin());
  Vector<3> nearest{};
  double rest = 1.0;  // 1 - sum of (coordinate / half axis)^2, which is 0 on the surface
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (y[axis] == 0.0) continue;
    const double below = s + (half_axes[axis] - half_axes[shortest]) * (half_axes[axis] + half_axes[shortest]);
    nearest[axis] = half_axes[axis] * half_axes[axis] * y[axis] / below;
    rest -= nearest[axis] * nearest[axis] / (half_axes[axis] * half_axes[axis]);
  }
  // Near the centre of the plane across the shortest axis the nearest points are on both sides of this plane.
  if (s == 0.0) nearest[shortest] = half_axes[shortest] * std::sqrt(std::max(0.0, rest));
  const double distance = norm(nearest - y);
  return ellipsoid.contains(point) ? -distance : distance;
}

double gap(const Ellipsoid& one, const Ellipsoid& other) {
  return EllipsoidSeparation(one, other).distance();
}

}  // namespace breccia

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "breccia/microstructure/particle.hpp"

#include "microstructure/vector_algebra.hpp"

namespace breccia {

/// Finds the distance of a point from a convex body that has the origin inside: the largest value of s(n) = n . (point
/// - support(n)) over all directions n (theory, Eq. 52). Every s(n) is a lower bound of the distance, and the segment
/// between two points of the body gives an upper bound.
///
/// s rises towards its maximum wherever it is positive. The direction of the maximum is enclosed between two other
/// directions, and found by approximating the outline by a circle of its radius of curvature, or by a straight side.
template <class Support>
class Separation {
 public:
  /// `support(direction)` is the SupportPoint of the body.
  Separation(const Vector<2>& point, const Support& support) : point_(point), support_(support) {}

  /// Stops as soon as the distance is certain to be `enough` [m] or more.
  ParticleGap distance(double enough) {
    const double far = norm(point_);
    if (far == 0.0) return {-support_(Vector<2>{1.0, 0.0}).point[0], {1.0, 0.0}};
    towards_ = point_ / far;
    lower_.direction = {towards_[1], -towards_[0]};
    upper_.direction = {-towards_[1], towards_[0]};
    constexpr int most_steps = 100;
    constexpr double tolerance = 1e-14;
    auto direction = towards_;
    for (int step = 0; step < most_steps; ++step) {
      const auto next = look_along(direction);
      if (best_.width >= enough || is_overlap_ || largest_ - best_.width <= tolerance * far || !next) break;
      direction = is_slow(step) ? middle().value_or(*next) : *next;
    }
    return best_;
  }

 private:
  struct End {
    Vector<2> direction{};
    std::optional<Vector<2>> point = {};  // point of the body farthest along the direction
  };

  static std::optional<Vector<2>> normalised(const Vector<2>& vector) {
    const double length = norm(vector);
    if (!(length > 0.0)) return std::nullopt;
    return vector / length;
  }

  [[nodiscard]] bool encloses(const std::optional<Vector<2>>& direction) const {
    constexpr double roundoff = 1e-15;
    return direction && cross(lower_.direction, *direction) > roundoff &&
           cross(*direction, upper_.direction) > roundoff;
  }

  /// Evaluates s along a direction, narrows the bounds, and returns the next direction; nothing if no direction is
  /// left.
  std::optional<Vector<2>> look_along(const Vector<2>& direction) {
    const auto [outermost, curvature] = support_(direction);
    const auto rest = point_ - outermost;
    const double distance = dot(direction, rest);
    if (distance > best_.width) best_ = {distance, direction};
    // Where s is negative the slope of its numerator is taken, which is concave along a straight line of directions.
    const double slope = distance > 0.0 ? cross(direction, rest) : cross(towards_, rest);
    (slope > 0.0 ? lower_ : upper_) = {direction, outermost};
    largest_ = std::min(largest_, norm(rest));
    const auto flat = lower_.point && upper_.point ? look_at_side() : std::nullopt;
    const auto round = curvature > 0.0 || !flat ? normalised(rest + curvature * direction) : std::nullopt;
    if (encloses(round)) return round;
    if (encloses(flat)) return flat;
    if (lower_.point && upper_.point && flat) return std::nullopt;
    return middle();
  }

  /// Whether to halve the angle between the two ends in this step, because the guesses have not converged.
  static bool is_slow(int step) {
    constexpr int many = 8;
    return step >= many && step % 2 == 0;
  }

  [[nodiscard]] std::optional<Vector<2>> middle() const {
    auto between = normalised(lower_.direction + upper_.direction);
    return encloses(between) ? between : std::nullopt;
  }

  /// Takes the outline between the two ends to be a straight side. Returns the direction from its nearest point.
  std::optional<Vector<2>> look_at_side() {
    const auto side = *upper_.point - *lower_.point;
    const auto normal = normalised({side[1], -side[0]});
    if (!normal) return std::nullopt;
    const auto from_start = point_ - *lower_.point;
    is_overlap_ = dot(*normal, from_start) <= 0.0;
    const double along = dot(from_start, side) / dot(side, side);
    if (along > 0.0 && along < 1.0) {
      largest_ = std::min(largest_, dot(*normal, from_start));
      return normal;
    }
    return normalised(along <= 0.0 ? from_start : point_ - *upper_.point);
  }

  Vector<2> point_, towards_{};
  const Support& support_;
  End lower_, upper_;
  ParticleGap best_ = {-std::numeric_limits<double>::infinity(), {1.0, 0.0}};
  double largest_ = std::numeric_limits<double>::infinity();  // upper bound of the distance
  bool is_overlap_ = false;
};

}  // namespace breccia

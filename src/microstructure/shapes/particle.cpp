#include "breccia/microstructure/particle.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "microstructure/shapes/separation.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia {
namespace {

/// The point of a posed shape farthest along a direction, from its centre.
SupportPoint support(const Shape& shape, const Pose& pose, const Vector<2>& direction) {
  const auto seen = pose.to_shape(direction);
  const auto [point, radius] = std::visit([&](const auto& one) { return one.support(seen); }, shape);
  return {pose.from_shape(point), radius};
}

struct InWords {
  std::string operator()(const Ellipse& ellipse) const {
    return fmt::format("ellipse of {:.6g} m x {:.6g} m", ellipse.axes[0], ellipse.axes[1]);
  }
  std::string operator()(const ConvexPolygon& polygon) const {
    return fmt::format("polygon of {} corners", polygon.corners().size());
  }
};

/// The direction along which a point inside a convex body is nearest to its outline, among a number of directions.
template <class Support>
ParticleGap shortest_way_out(const Vector<2>& point, const Support& support, ParticleGap best) {
  constexpr int directions = 360;
  for (int step = 0; step < directions; ++step) {
    const double angle = 2.0 * std::numbers::pi * step / directions;
    const Vector<2> direction = {std::cos(angle), std::sin(angle)};
    const double width = dot(direction, point - support(direction).point);
    if (width > best.width) best = {width, direction};
  }
  return best;
}

}  // namespace

Pose::Pose(const Vector<2>& centre, double angle) noexcept
    : centre_(centre), angle_(angle), cosine_(std::cos(angle)), sine_(std::sin(angle)) {}

Pose Pose::at(const Vector<2>& centre) const noexcept {
  auto moved = *this;
  moved.centre_ = centre;
  return moved;
}

double area(const Shape& shape) {
  return std::visit([](const auto& one) { return area(one); }, shape);
}

double perimeter(const Shape& shape) {
  return std::visit([](const auto& one) { return perimeter(one); }, shape);
}

double circumradius(const Shape& shape) {
  return std::visit([](const auto& one) { return circumradius(one); }, shape);
}

double equivalent_diameter(const Shape& shape) {
  return 2.0 * std::sqrt(area(shape) / std::numbers::pi);
}

std::string in_words(const Shape& shape) {
  return std::visit(InWords(), shape);
}

std::array<Vector<2>, 2> extent(const Shape& shape, const Pose& pose) {
  const auto reach = [&](const Vector<2>& direction) { return dot(direction, support(shape, pose, direction).point); };
  return {{{reach({-1.0, 0.0}), reach({1.0, 0.0})}, {reach({0.0, -1.0}), reach({0.0, 1.0})}}};
}

double signed_distance(const Particle& particle, const Vector<2>& point) {
  const auto& [shape, pose] = particle;
  const auto seen = pose.to_shape(point - pose.centre());
  const auto distance = [&](const auto& one) {
    if (one.contains(seen)) return -one.depth(seen);
    const auto support = [&one](const Vector<2>& direction) { return one.support(direction); };
    return std::max(0.0, Separation(seen, support).distance(std::numeric_limits<double>::infinity()).width);
  };
  return std::visit(distance, shape);
}

ParticleGap gap(const Shape& one, const Pose& at_one, const Shape& other, const Pose& at_other, double enough) {
  // The gap is the distance of the centre of the second shape from the first shape grown by the second one, turned
  // around (Minkowski sum).
  const auto grown = [&](const Vector<2>& direction) -> SupportPoint {
    const auto [point, radius] = support(one, at_one, direction);
    const auto [behind, radius_behind] = support(other, at_other, {-direction[0], -direction[1]});
    return {point - behind, radius + radius_behind};
  };
  const auto apart = at_other.centre() - at_one.centre();
  const auto found = Separation(apart, grown).distance(enough);
  return found.width < 0.0 && std::isinf(enough) ? shortest_way_out(apart, grown, found) : found;
}

}  // namespace breccia

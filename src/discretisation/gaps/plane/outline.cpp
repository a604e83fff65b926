#include "discretisation/gaps/plane/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microstructure/disc_overlap.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

struct WithoutLayer {
  const Particle& particle;
  double layer, factor;

  using Outlines = std::variant<Disc, EllipseOutline, PolygonOutline>;
  Outlines operator()(const Ellipse& ellipse) const {
    const auto centre = factor * particle.pose.centre();
    if (ellipse.axes[0] == ellipse.axes[1]) return Disc{centre, factor * (ellipse.axes[0] + 2.0 * layer)};
    return EllipseOutline{0.5 * factor * ellipse.axes, particle.pose.at(centre)};
  }
  Outlines operator()(const ConvexPolygon& polygon) const {
    PolygonOutline outline;
    for (const auto& corner : polygon.corners()) {
      outline.corners.push_back(factor * (particle.pose.centre() + particle.pose.from_shape(corner)));
    }
    return outline;
  }
};

/// The outline at a distance from a particle as a polygon of the same area but for some 1e-5.
PolygonOutline around(const Particle& particle, double layer, double factor) {
  constexpr int corners = 1440;
  PolygonOutline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    const Vector<2> normal = {std::cos(angle), std::sin(angle)};
    const auto seen = particle.pose.to_shape(normal);
    const auto support = std::visit([&](const auto& shape) { return shape.support(seen); }, particle.shape);
    outline.corners.push_back(factor *
                              (particle.pose.centre() + particle.pose.from_shape(support.point) + layer * normal));
  }
  return outline;
}

void move(Disc& disc, const Vector<2>& by) {
  disc.centre += by;
}
void move(EllipseOutline& ellipse, const Vector<2>& by) {
  ellipse.pose = ellipse.pose.at(ellipse.pose.centre() + by);
}
void move(PolygonOutline& polygon, const Vector<2>& by) {
  for (auto& corner : polygon.corners) corner += by;
}

}  // namespace

FromOutline from_outline(const Disc& disc, const Vector<2>& point) noexcept {
  const auto from_centre = point - disc.centre;
  return {norm(from_centre) - 0.5 * disc.diameter, direction(from_centre)};
}

std::optional<Interval> chord(const Disc& disc, const GridLine<2>& line) noexcept {
  const auto to_centre = disc.centre - line.origin;
  const double off = to_centre[1 - line.axis], radius = 0.5 * disc.diameter;
  if (std::abs(off) >= radius) return std::nullopt;
  const double half = std::sqrt((radius - off) * (radius + off));
  return Interval{to_centre[line.axis] - half, to_centre[line.axis] + half};
}

double area_in_square(const Disc& disc, const Vector<2>& corner) {
  return overlap_area(disc, corner, corner + Vector<2>{1.0, 1.0});
}

Outline::Outline(const Particle& particle, double layer, double factor)
    : centre_(factor * particle.pose.centre()),
      reach_(factor * (circumradius(particle.shape) + layer)),
      layer_(factor * layer),
      particle_(std::visit(WithoutLayer{particle, layer, factor}, particle.shape)) {
  if (std::holds_alternative<Disc>(particle_)) layer_ = 0.0;
  if (layer_ > 0.0) with_layer_ = around(particle, layer, factor);
}

Outline Outline::moved(const Vector<2>& by) const {
  auto outline = *this;
  outline.centre_ += by;
  std::visit([&](auto& particle) { move(particle, by); }, outline.particle_);
  move(outline.with_layer_, by);
  return outline;
}

FromOutline Outline::from(const Vector<2>& point) const {
  return std::visit([&](const auto& particle) { return from_outline(particle, point); }, particle_);
}

std::optional<Interval> Outline::chord(const GridLine<2>& line) const {
  if (layer_ > 0.0) return gaps::chord(with_layer_, line);
  return std::visit([&](const auto& particle) { return gaps::chord(particle, line); }, particle_);
}

double Outline::content_of_cell(const Vector<2>& corner) const {
  constexpr double half_diagonal = 0.7072;
  const double to_middle = distance(corner + Vector<2>{0.5, 0.5});
  if (to_middle > half_diagonal) return 0.0;
  if (to_middle < -half_diagonal) return 1.0;
  if (layer_ > 0.0) return gaps::area_in_square(with_layer_, corner);
  return std::visit([&](const auto& particle) { return gaps::area_in_square(particle, corner); }, particle_);
}

}  // namespace breccia::gaps

#include "discretisation/gaps/space/sphere_outline.hpp"

#include <cmath>

#include "microstructure/sphere_overlap.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {

SphereOutline::SphereOutline(const Sphere& sphere, double layer, double factor)
    : sphere_{factor * sphere.centre, factor * (sphere.diameter + 2.0 * layer)} {}

SphereOutline SphereOutline::moved(const Vector<3>& by) const {
  auto other = *this;
  other.sphere_.centre += by;
  return other;
}

double SphereOutline::distance(const Vector<3>& point) const {
  return norm(point - centre()) - reach();
}

Vector<3> SphereOutline::normal(const Vector<3>& point) const {
  return direction(point - centre());
}

std::optional<Interval> SphereOutline::chord(const GridLine<3>& line) const {
  const auto from_centre = line.origin - centre();
  const double middle = -from_centre[line.axis];
  const double square = middle * middle - dot(from_centre, from_centre) + reach() * reach();
  if (!(square > 0.0)) return std::nullopt;
  const double half = std::sqrt(square);
  return Interval{middle - half, middle + half};
}

double SphereOutline::content_of_cell(const Vector<3>& corner) const {
  return overlap_volume(sphere_, corner, corner + Vector<3>{1.0, 1.0, 1.0});
}

}  // namespace breccia::gaps

#include "breccia/microstructure/ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace breccia {
namespace {

/// Distance of a point from the centre, where its coordinates are divided by the half axes; 1 on the outline.
double length_in_half_axes(const Ellipse& ellipse, const Vector<2>& point) noexcept {
  return std::hypot(2.0 * point[0] / ellipse.axes[0], 2.0 * point[1] / ellipse.axes[1]);
}

}  // namespace

SupportPoint Ellipse::support(const Vector<2>& direction) const noexcept {
  const double a = 0.5 * axes[0], b = 0.5 * axes[1];
  const double height = std::sqrt(a * a * direction[0] * direction[0] + b * b * direction[1] * direction[1]);
  return {{a * a * direction[0] / height, b * b * direction[1] / height}, a * a * b * b / (height * height * height)};
}

bool Ellipse::contains(const Vector<2>& point) const noexcept {
  return length_in_half_axes(*this, point) <= 1.0;
}

double Ellipse::depth(const Vector<2>& point) const noexcept {
  // The length in half axes changes by at most 1 / (smaller half axis) per length.
  return std::max(0.0, 0.5 * std::min(axes[0], axes[1]) * (1.0 - length_in_half_axes(*this, point)));
}

double area(const Ellipse& ellipse) noexcept {
  return 0.25 * std::numbers::pi * ellipse.axes[0] * ellipse.axes[1];
}

double perimeter(const Ellipse& ellipse) {
  const auto [shorter, longer] = std::minmax(ellipse.axes[0], ellipse.axes[1]);
  const double ratio = shorter / longer;
  return 2.0 * longer * std::comp_ellint_2(std::sqrt((1.0 - ratio) * (1.0 + ratio)));
}

double circumradius(const Ellipse& ellipse) noexcept {
  return 0.5 * std::max(ellipse.axes[0], ellipse.axes[1]);
}

}  // namespace breccia

#include "breccia/microstructure/ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace breccia {
namespace {

/// Length of a place whose coordinates are counted in half axes; 1 on the outline.
double length_in_half_axes(const Ellipse& ellipse, const Vector<2>& place) noexcept {
  return std::hypot(2.0 * place[0] / ellipse.axes[0], 2.0 * place[1] / ellipse.axes[1]);
}

}  // namespace

SupportPoint Ellipse::support(const Vector<2>& direction) const noexcept {
  const double a = 0.5 * axes[0], b = 0.5 * axes[1];
  const double height = std::sqrt(a * a * direction[0] * direction[0] + b * b * direction[1] * direction[1]);
  return {{a * a * direction[0] / height, b * b * direction[1] / height}, a * a * b * b / (height * height * height)};
}

bool Ellipse::contains(const Vector<2>& place) const noexcept {
  return length_in_half_axes(*this, place) <= 1.0;
}

double Ellipse::depth(const Vector<2>& place) const noexcept {
  // The length in half axes changes by at most 1 / (smaller half axis) per length.
  return std::max(0.0, 0.5 * std::min(axes[0], axes[1]) * (1.0 - length_in_half_axes(*this, place)));
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

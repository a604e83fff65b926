#include "microstructure/disc_overlap.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

/// Area between the x axis and a circle of radius r about the origin, from 0 to x, 0 <= x <= r.
double area_under_circle(double x, double r) {
  return 0.5 * (x * std::sqrt((r - x) * (r + x)) + r * r * std::asin(x / r));
}

/// Integral from 0 to x of min(y, c), where c is the height of a circle of radius r about the origin; y >= 0. Odd in x.
double area_under_both(double x, double y, double r) {
  const double end = std::min(std::abs(x), r);
  const double crossing = y < r ? std::sqrt((r - y) * (r + y)) : 0.0;
  const double flat = std::min(end, crossing);
  const double area = y * flat + area_under_circle(end, r) - area_under_circle(flat, r);
  return std::copysign(area, x);
}

/// Area of the disc above the x axis (below, and negative, for a negative y) between x0 and x1, cut off at the height
/// y.
double area_up_to(double y, double x0, double x1, double r) {
  return std::copysign(area_under_both(x1, std::abs(y), r) - area_under_both(x0, std::abs(y), r), y);
}

}  // namespace

double overlap_area(const Disc& disc, const Vector<2>& lower, const Vector<2>& upper) {
  const double r = 0.5 * disc.diameter;
  const double x0 = lower[0] - disc.centre[0], x1 = upper[0] - disc.centre[0];
  return area_up_to(upper[1] - disc.centre[1], x0, x1, r) - area_up_to(lower[1] - disc.centre[1], x0, x1, r);
}

}  // namespace breccia

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/size_distribution.hpp"

namespace breccia {

namespace {

double disc_area(double diameter) {
  return std::numbers::pi / 4.0 * diameter * diameter;
}

/// The diameter of the next disc: the root of F(d) + (area above + a(d)/2) / total area = 1, whose left side rises.
double next_diameter(const SizeDistribution& distribution, double area_above, double total_area) {
  double low = distribution.smallest();
  double high = distribution.largest();
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high)) {
    const double covered = (area_above + 0.5 * disc_area(middle)) / total_area;
    (distribution.cumulative(middle) + covered >= 1.0 ? high : low) = middle;
  }
  return high;
}

}  // namespace

std::vector<double> draw_diameters(const SizeDistribution& distribution, double fraction, double side) {
  if (!(fraction > 0.0 && fraction < 1.0)) {
    throw InputError(
        fmt::format("drawing particle sizes: the area fraction must be between 0 and 1, got {}", fraction));
  }
  if (!(side > 0.0) || !std::isfinite(side)) {
    throw InputError(fmt::format("drawing particle sizes: the side of the box must be positive, got {} m", side));
  }
  if (!(distribution.smallest() > 0.0) || !std::isfinite(distribution.largest())) {
    throw InputError(
        fmt::format("drawing particle sizes: the size distribution goes from {} m to {} m; truncate it to a smallest "
                    "diameter above zero and a finite largest one",
                    distribution.smallest(), distribution.largest()));
  }
  const double total_area = fraction * side * side;
  const double half_smallest = 0.5 * disc_area(distribution.smallest());
  std::vector<double> diameters;
  for (double area = 0.0; area + half_smallest < total_area; area += disc_area(diameters.back())) {
    diameters.push_back(next_diameter(distribution, area, total_area));
    if (diameters.size() > most_particles) {
      throw NumericalError(fmt::format(
          "drawing particle sizes: a fraction {} of a box of side {} m holds more than {} particles of {} m to {} m",
          fraction, side, most_particles, distribution.smallest(), distribution.largest()));
    }
  }
  if (diameters.empty()) {
    throw NumericalError(
        fmt::format("drawing particle sizes: a fraction {} of a box of side {} m is less than half a particle of the "
                    "smallest diameter, {} m",
                    fraction, side, distribution.smallest()));
  }
  return diameters;
}

double largest_deviation(const SizeDistribution& distribution, std::span<const double> diameters) {
  std::vector<double> rising(diameters.begin(), diameters.end());
  std::ranges::sort(rising);
  double total_area = 0.0;
  for (const double diameter : rising) total_area += disc_area(diameter);
  // The drawn distribution is a staircase, so the largest difference is just below or at one of its steps.
  double deviation = 0.0;
  double area = 0.0;
  for (auto step = rising.begin(); step != rising.end();) {
    const double diameter = *step;
    const double before = distribution.cumulative(std::nextafter(diameter, 0.0)) - area / total_area;
    for (; step != rising.end() && *step == diameter; ++step) area += disc_area(diameter);
    const double after = distribution.cumulative(diameter) - area / total_area;
    deviation = std::max({deviation, std::abs(before), std::abs(after)});
  }
  return deviation;
}

}  // namespace breccia

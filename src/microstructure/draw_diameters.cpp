#include "breccia/microstructure/draw_diameters.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/ball.hpp"

namespace breccia {

namespace {

/// The diameter of the next ball: the root of F(d) + (volume above + v(d)/2) / total volume = 1, whose left side rises.
template <int dim>
double next_diameter(const SizeDistribution& distribution, double volume_above, double total_volume) {
  double low = distribution.smallest();
  double high = distribution.largest();
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high)) {
    const double covered = (volume_above + 0.5 * ball_volume<dim>(middle)) / total_volume;
    (distribution.cumulative(middle) + covered >= 1.0 ? high : low) = middle;
  }
  return high;
}

}  // namespace

template <int dim>
std::vector<double> draw_diameters(const SizeDistribution& distribution, double fraction, double side) {
  if (!(fraction > 0.0 && fraction < 1.0)) {
    throw InputError(fmt::format("drawing particle sizes: the {} fraction must be between 0 and 1, got {}",
                                 dim == 2 ? "area" : "volume", fraction));
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
  const double total_volume = times_power<dim>(fraction, side);
  const double half_smallest = 0.5 * ball_volume<dim>(distribution.smallest());
  std::vector<double> diameters;
  for (double volume = 0.0; volume + half_smallest < total_volume; volume += ball_volume<dim>(diameters.back())) {
    diameters.push_back(next_diameter<dim>(distribution, volume, total_volume));
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

template <int dim>
double largest_deviation(const SizeDistribution& distribution, std::span<const double> diameters) {
  std::vector<double> rising(diameters.begin(), diameters.end());
  std::ranges::sort(rising);
  double total_volume = 0.0;
  for (const double diameter : rising) total_volume += ball_volume<dim>(diameter);
  // The drawn distribution is a step function, so the largest difference is just below or at one of its steps.
  double deviation = 0.0;
  double volume = 0.0;
  for (auto step = rising.begin(); step != rising.end();) {
    const double diameter = *step;
    const double before = distribution.cumulative(std::nextafter(diameter, 0.0)) - volume / total_volume;
    for (; step != rising.end() && *step == diameter; ++step) volume += ball_volume<dim>(diameter);
    const double after = distribution.cumulative(diameter) - volume / total_volume;
    deviation = std::max({deviation, std::abs(before), std::abs(after)});
  }
  return deviation;
}

template std::vector<double> draw_diameters<2>(const SizeDistribution&, double, double);
template double largest_deviation<2>(const SizeDistribution&, std::span<const double>);
template std::vector<double> draw_diameters<3>(const SizeDistribution&, double, double);
template double largest_deviation<3>(const SizeDistribution&, std::span<const double>);

}  // namespace breccia

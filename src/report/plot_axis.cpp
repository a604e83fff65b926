#include "report/plot_axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "report/even_values.hpp"

namespace breccia {

namespace {

constexpr double rounding_of_ticks = 1e-9;  // relative; keeps ticks that lie on the ends

/// A tick with a label, which is a power of ten or has the value in digits.
Tick labelled_tick(double at, int digit, int exponent, bool is_power) {
  if (!is_power) return {at, fmt::format("{:g}", at), ""};
  return {at, digit == 1 ? "10" : fmt::format("{}×10", digit),
          fmt::format("{}{}", exponent < 0 ? "−" : "", std::abs(exponent))};
}

}  // namespace

double PlotAxis::share(double value) const {
  if (scale == AxisScale::linear) return (value - begin) / (end - begin);
  return std::log(value / begin) / std::log(end / begin);
}

PlotAxis log_axis(double smallest, double largest, double margin) {
  const double widening = std::sqrt(std::max(1.0, 4.0 * smallest / largest));
  PlotAxis axis{smallest / margin / widening, largest * margin * widening, AxisScale::logarithmic, {}};

  const double decades = std::log10(axis.end / axis.begin);
  const bool labels_two_and_five = decades <= 2.0;
  const int labelled_exponents = std::max(1, static_cast<int>(std::ceil(decades / 9.0 - rounding_of_ticks)));
  const bool powers = axis.begin < 0.999e-3 || axis.end > 1e4;

  const int first = static_cast<int>(std::floor(std::log10(axis.begin)));
  const int last = static_cast<int>(std::floor(std::log10(axis.end) + rounding_of_ticks));
  for (int exponent = first; exponent <= last; ++exponent) {
    for (int digit = 1; digit <= 9; ++digit) {
      const double at = digit * std::pow(10.0, exponent);
      if (at < axis.begin * (1.0 - rounding_of_ticks) || at > axis.end * (1.0 + rounding_of_ticks)) continue;
      if (digit > 1 && labelled_exponents > 1) continue;
      const bool labelled =
          (digit == 1 && exponent % labelled_exponents == 0) || (labels_two_and_five && (digit == 2 || digit == 5));
      axis.ticks.push_back(labelled ? labelled_tick(at, digit, exponent, powers) : Tick{at, "", ""});
    }
  }
  return axis;
}

PlotAxis linear_axis(double smallest, double largest) {
  PlotAxis axis{smallest, largest, AxisScale::linear, {}};
  const double rounding = 1e-3 * (largest - smallest);  // keeps ticks that lie on the ends
  for (auto& [value, label] : even_values(smallest - rounding, largest + rounding))
    axis.ticks.push_back({value, std::move(label), ""});
  return axis;
}

}  // namespace breccia

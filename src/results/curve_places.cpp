#include "results/curve_places.hpp"

#include <cmath>
#include <numbers>

#include "breccia/virtual_test/curve.hpp"

#include "io/display.hpp"

namespace breccia {

double axis_value(double at, Abscissa abscissa) {
  return abscissa == Abscissa::time ? at : at / (2.0 * std::numbers::pi);
}

std::vector<std::size_t> decades_of(const std::vector<double>& at, Abscissa abscissa) {
  std::vector<std::size_t> indices;
  const double first = axis_value(at.front(), abscissa), last = axis_value(at.back(), abscissa);
  for (const double place : logarithmic_times({first, last}, 1)) {
    std::size_t nearest = 0;
    const auto distance = [&](std::size_t one) { return std::abs(std::log(axis_value(at[one], abscissa) / place)); };
    for (std::size_t i = 1; i < at.size(); ++i) {
      if (distance(i) < distance(nearest)) nearest = i;
    }
    if (indices.empty() || indices.back() != nearest) indices.push_back(nearest);
  }
  return indices;
}

std::string place_in_words(double at, Abscissa abscissa) {
  const double value = axis_value(at, abscissa);
  return abscissa == Abscissa::time ? display_time(value) : display(value, "Hz");
}

}  // namespace breccia

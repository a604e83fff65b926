#include "virtual_test/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "breccia/error.hpp"

namespace breccia {

Extrapolated extrapolate(std::span<const double> cell_sides, std::span<const double> values) {
  const auto count = cell_sides.size();
  if (count < 2 || count > 3 || values.size() != count) {
    throw InputError("extrapolation: expected the values of two or three grids");
  }
  for (std::size_t i = 1; i < count; ++i) {
    if (!(cell_sides[i] > 0.0) || !(cell_sides[i] < cell_sides[i - 1])) {
      throw InputError("extrapolation: expected cell sides that fall");
    }
  }
  // The value is linear in the cell side: v(h) = v(0) + slope h.
  const auto limit = [&](std::size_t coarse) {
    const double slope = (values[coarse] - values[coarse + 1]) / (cell_sides[coarse] - cell_sides[coarse + 1]);
    return values[coarse + 1] - slope * cell_sides[coarse + 1];
  };
  const double value = limit(count - 2);
  const double correction = std::abs(value - values[count - 1]);
  if (count == 2) return {value, 0.5 * correction};
  return {value, std::max(std::abs(value - limit(0)), 0.25 * correction)};
}

std::vector<double> largest_errors(std::span<const double> coarse, std::span<const double> fine, double ratio) {
  if (coarse.size() != fine.size()) throw InputError("error band: expected two curves at the same times");
  if (!(ratio > 1.0)) throw InputError("error band: expected a grid that is finer than the other");
  const double of_change = 1.0 / (std::min(ratio, 2.0) - 1.0);
  std::vector<double> errors;
  double largest = 0.0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    largest = std::max(largest, of_change * std::abs(coarse[i] / fine[i] - 1.0));
    errors.push_back(largest);
  }
  return errors;
}

}  // namespace breccia

#include "viscoelasticity/fitted_data.hpp"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

void require_fitted_data(std::span<const double> at, std::initializer_list<std::span<const double>> values,
                         const char* what) {
  for (const auto& column : values) {
    if (column.size() != at.size()) throw InputError(fmt::format("{}: columns of different lengths", what));
  }
  constexpr std::size_t fewest = 3;
  if (at.size() < fewest)
    throw InputError(fmt::format("{}: expected at least {} data, got {}", what, fewest, at.size()));
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (!(at[i] > 0.0) || !std::isfinite(at[i]) || (i > 0 && at[i] < at[i - 1])) {
      throw InputError(
          fmt::format("{}: datum {}: expected positive numbers that do not fall, got {}", what, i + 1, at[i]));
    }
    for (const auto& column : values) {
      if (column[i] > 0.0 && std::isfinite(column[i])) continue;
      throw InputError(fmt::format("{}: datum {}: expected a positive number, got {}", what, i + 1, column[i]));
    }
  }
}

}  // namespace breccia

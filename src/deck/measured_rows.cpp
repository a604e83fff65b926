#include "deck/measured_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

#include "io/file_mistakes.hpp"

namespace breccia {
namespace {

/// The expected value of a number in a column, in words.
std::string_view expected_in(const MeasuredColumn& column) {
  if (column.quantity == Quantity::temperature) return "a temperature above absolute zero";
  return column.quantity == Quantity::phase_angle ? "an angle above 0 and below 90 degrees" : "a positive number";
}

}  // namespace

void require_positive(const MeasuredTable& table, const std::vector<const MeasuredColumn*>& columns) {
  FileMistakes mistakes(table.path());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const auto* column : columns) {
      const double value = column->values[row];
      const bool is_below =
          column->quantity == Quantity::phase_angle ? value < std::numbers::pi / 2 : std::isfinite(value);
      if (value > 0.0 && is_below) continue;
      mistakes.add(table.location(row), fmt::format("{}: expected {}", column->name, expected_in(*column)),
                   fmt::format("{}", column->written[row]));
    }
  }
  mistakes.refuse();
}

std::vector<std::size_t> rising_rows(const std::vector<double>& column) {
  std::vector<std::size_t> rows(column.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return column[row]; });
  return rows;
}

std::vector<double> in_order(const std::vector<double>& column, const std::vector<std::size_t>& rows) {
  std::vector<double> values(rows.size());
  std::ranges::transform(rows, values.begin(), [&](std::size_t row) { return column[row]; });
  return values;
}

}  // namespace breccia

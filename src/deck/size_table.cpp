#include "deck/size_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/tables/measured_table_reader.hpp"

#include "io/file_mistakes.hpp"

namespace breccia {
namespace {

/// The numbers of the rows by rising diameter: sieve analyses often begin with the largest one.
std::vector<std::size_t> rising_rows(const std::vector<double>& diameters) {
  std::vector<std::size_t> rows(diameters.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  if (diameters.front() > diameters.back()) std::ranges::reverse(rows);
  return rows;
}

}  // namespace

TabulatedSizes read_size_table(const std::filesystem::path& path) {
  const auto table = read_measured_table(path);
  table.require({Quantity::diameter, Quantity::cumulative_volume_fraction});
  const auto& diameters = table.column(Quantity::diameter);
  const auto& fractions = table.column(Quantity::cumulative_volume_fraction);
  if (table.rows() < 2) throw InputError(fmt::format("{}: expected at least two rows", path.string()));
  FileMistakes mistakes(path);
  const auto add = [&](std::size_t row, const char* expected, const MeasuredColumn& column) {
    mistakes.add(table.location(row), expected, fmt::format("{}", column.written[row]));
  };
  const auto rows = rising_rows(diameters.values);
  TabulatedSizes sizes{path, {}, {}};
  for (const auto row : rows) {
    const double diameter = diameters.values[row], fraction = fractions.values[row];
    const double smaller = sizes.diameters.empty() ? 0.0 : sizes.diameters.back();
    const double least = sizes.diameters.empty() ? 0.0 : sizes.cumulative_volume_fractions.back();
    if (!(diameter > smaller) || !std::isfinite(diameter)) {
      add(row, "expected positive diameters that rise or fall from row to row", diameters);
    } else if (!(fraction >= least && fraction <= 1.0)) {
      add(row,
          "expected the volume fraction up to each diameter, which does not fall with it, from 0 to 1, or in per cent "
          "in a column called passing [%]",
          fractions);
    } else {
      sizes.diameters.push_back(diameter);
      sizes.cumulative_volume_fractions.push_back(fraction);
    }
  }
  const bool is_rising = mistakes.empty();
  if (is_rising && sizes.cumulative_volume_fractions.front() != 0.0) {
    add(rows.front(), "expected the volume fraction to be 0 at the smallest diameter, the size that nothing passes",
        fractions);
  }
  if (is_rising && sizes.cumulative_volume_fractions.back() != 1.0) {
    add(rows.back(), "expected the volume fraction to be 1 at the largest diameter", fractions);
  }
  mistakes.refuse();
  return sizes;
}

}  // namespace breccia

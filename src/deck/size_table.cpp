#include "deck/size_table.hpp"

#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/tables/measured_table_reader.hpp"

#include "io/file_mistakes.hpp"

namespace breccia {

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
  double smaller = 0.0, least = 0.0;  // values of the last correct row
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double diameter = diameters.values[row], fraction = fractions.values[row];
    if (!(diameter > smaller) || !std::isfinite(diameter)) {
      add(row, "expected rising positive diameters", diameters);
    } else if (!(fraction >= least && fraction <= 1.0)) {
      add(row, "expected a cumulative volume fraction that does not fall, from 0 to 1", fractions);
    } else {
      smaller = diameter;
      least = fraction;
    }
  }
  const auto last = table.rows() - 1;
  const bool is_rising = mistakes.empty();
  if (is_rising && fractions.values.front() != 0.0) {
    add(0, "expected the cumulative volume fraction to begin at 0", fractions);
  }
  if (is_rising && fractions.values.back() != 1.0) {
    add(last, "expected the cumulative volume fraction to end at 1", fractions);
  }
  mistakes.refuse();
  return {path, diameters.values, fractions.values};
}

}  // namespace breccia

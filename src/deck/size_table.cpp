#include "breccia/deck/size_table.hpp"

#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/measured_table_reader.hpp"

namespace breccia {

TabulatedSizes read_size_table(const std::filesystem::path& path) {
  const auto table = read_measured_table(path);
  table.require({Quantity::diameter, Quantity::cumulative_volume_fraction});
  const auto& diameters = table.column(Quantity::diameter).values;
  const auto& fractions = table.column(Quantity::cumulative_volume_fraction).values;
  if (table.rows() < 2) throw InputError(fmt::format("{}: expected at least two rows", path.string()));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double below = row == 0 ? 0.0 : diameters[row - 1];
    if (!(diameters[row] > below) || !std::isfinite(diameters[row])) {
      throw InputError(
          fmt::format("{}: expected rising diameters, got {} after {}", table.place(row), diameters[row], below));
    }
    const double least = row == 0 ? 0.0 : fractions[row - 1];
    if (!(fractions[row] >= least && fractions[row] <= 1.0)) {
      throw InputError(fmt::format("{}: expected a cumulative volume fraction between {} and 1, got {}",
                                   table.place(row), least, fractions[row]));
    }
  }
  if (fractions.front() != 0.0) {
    throw InputError(fmt::format("{}: expected the cumulative volume fraction to begin at 0, got {}", table.place(0),
                                 fractions.front()));
  }
  if (fractions.back() != 1.0) {
    throw InputError(fmt::format("{}: expected the cumulative volume fraction to end at 1, got {}",
                                 table.place(table.rows() - 1), fractions.back()));
  }
  return {path, diameters, fractions};
}

}  // namespace breccia

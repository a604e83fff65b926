#include "deck/size_table.hpp"

#include <cstddef>
#include <string>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/tables/measured_table_reader.hpp"

#include "deck/size_rows.hpp"
#include "io/file_mistakes.hpp"

namespace breccia {

TabulatedSizes read_size_table(const std::filesystem::path& path) {
  const auto table = read_measured_table(path);
  table.require({Quantity::diameter, Quantity::cumulative_volume_fraction});
  if (table.rows() < 2) throw InputError(fmt::format("{}: expected at least two rows", path.string()));
  const auto& diameters = table.column(Quantity::diameter);
  const auto& fractions = table.column(Quantity::cumulative_volume_fraction);
  FileMistakes mistakes(path);
  const auto reporter_of = [&](const MeasuredColumn& column) {
    return [&mistakes, &table, &column](std::size_t row, const std::string& expected) {
      mistakes.add(table.location(row), expected, fmt::format("{}", column.written[row]));
    };
  };
  auto sizes = table_of({diameters.values, fractions.values}, reporter_of(diameters), reporter_of(fractions));
  mistakes.refuse();
  sizes.file = path;
  return sizes;
}

}  // namespace breccia

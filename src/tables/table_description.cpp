#include "tables/table_description.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/display.hpp"
#include "io/file_mistakes.hpp"

namespace breccia {
namespace {

std::string_view words_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::time:
      return "time";
    case Quantity::relaxation_time:
      return "relaxation time";
    case Quantity::modulus:
      return "modulus";
    case Quantity::compliance:
      return "compliance";
    case Quantity::storage_modulus:
      return "storage modulus";
    case Quantity::loss_modulus:
      return "loss modulus";
    case Quantity::absolute_modulus:
      return "absolute modulus";
    case Quantity::phase_angle:
      return "phase angle";
    case Quantity::loss_tangent:
      return "loss tangent";
    case Quantity::angular_frequency:
      return "frequency";
    case Quantity::temperature:
      return "temperature";
    case Quantity::shift_factor:
    case Quantity::log10_shift_factor:
      return "shift factor";
    default:
      return "other quantity";
  }
}

std::string_view words_of(ModulusKind kind) {
  switch (kind) {
    case ModulusKind::shear:
      return " (shear)";
    case ModulusKind::young:
      return " (Young's)";
    case ModulusKind::bulk:
      return " (bulk)";
    case ModulusKind::other:
      return " (of another kind)";
    default:
      return "";
  }
}

std::string_view words_of(char separator) {
  switch (separator) {
    case ';':
      return "semicolons";
    case '\t':
      return "tabs";
    case ' ':
      return "blanks";
    default:
      return "commas";
  }
}

std::string layout_of(const MeasuredTable& table) {
  const auto& reading = table.reading();
  const auto tables = reading.tables > 1 ? fmt::format(" of {} tables", reading.tables) : "";
  if (!reading.sheet.empty()) {
    return fmt::format("{}: {}{}, sheet {}, {}names in row {}{}", table.path().string(),
                       display_count(table.rows(), "row"), tables, shown_value(reading.sheet),
                       reading.has_decimal_commas ? "decimal commas, " : "", reading.line_of_names,
                       reading.has_row_of_units ? ", units below" : "");
  }
  return fmt::format("{}: {}{}, {}, {}{} between columns, names in line {}{}", table.path().string(),
                     display_count(table.rows(), "row"), tables, reading.encoding,
                     reading.has_decimal_commas ? "decimal commas, " : "", words_of(reading.separator),
                     reading.line_of_names, reading.has_row_of_units ? ", units below" : "");
}

}  // namespace

std::string description_of(const MeasuredTable& table) {
  auto text = layout_of(table);
  auto ignored = table.names();
  for (const auto& column : table.columns()) {
    const auto [least, most] = std::ranges::minmax(column.written.empty() ? std::vector{0.0} : column.written);
    const auto unit = column.unit.empty() ? "" : fmt::format(" [{}]", column.unit);
    text +=
        fmt::format("\n  {:<26} {}{}, {} to {}", fmt::format("{}{}", words_of(column.quantity), words_of(column.kind)),
                    shown_value(column.name), unit, three_digits(least), three_digits(most));
    std::erase(ignored, column.name);
  }
  std::erase(ignored, "");
  if (ignored.empty()) return text;
  std::vector<std::string> shown;
  shown.reserve(ignored.size());
  for (const auto& name : ignored) shown.push_back(shown_value(name));
  return text + fmt::format("\n  {:<26} {}", "not read", fmt::join(shown, ", "));
}

}  // namespace breccia

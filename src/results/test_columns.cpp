#include "results/test_columns.hpp"

#include <charconv>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

std::string text_if_known(const std::optional<double>& number) {
  return number ? fmt::format("{}", *number) : "";
}

std::optional<double> number_if_known(const CsvTable& table, const std::string& column, std::size_t row) {
  const auto& text = table.text(column)[row];
  if (text.empty()) return std::nullopt;
  double number = 0.0;
  const auto* const end = text.data() + text.size();
  const auto [stop, mistake] = std::from_chars(text.data(), end, number);
  if (mistake == std::errc() && stop == end) return number;
  throw FileError(fmt::format("{}: not as `breccia run` writes it: {} is no number", table.location(row), column));
}

TestId id_of_row(const CsvTable& table, std::size_t row) {
  const auto load = table.has("load") ? value_named<TestLoad>(table.text("load")[row]) : Load::shear;
  const auto boundary = value_named<Boundary>(table.text("boundary")[row]);
  const auto method = value_named<Method>(table.text("method")[row]);
  const auto grid = table.has("cells") ? grid_named(table.text("cells")[row]) : TestGrid::extrapolated();
  if (load && boundary && method && grid) return {*load, *boundary, *method, *grid};
  throw FileError(fmt::format("{}: not as `breccia run` writes it", table.location(row)));
}

void TestColumns::add(const std::string& stage, const TestId& test) {
  stages.push_back(stage);
  loads.push_back(name_of(test.load));
  boundaries.push_back(name_of(test.boundary));
  methods.push_back(name_of(test.method));
  cells.push_back(name_of(test.grid));
}

void TestColumns::append_to(std::vector<CsvColumn>& table) const {
  table.insert(table.end(),
               {{"stage", stages}, {"load", loads}, {"boundary", boundaries}, {"method", methods}, {"cells", cells}});
}

}  // namespace breccia

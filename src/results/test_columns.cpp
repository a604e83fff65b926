#include "results/test_columns.hpp"

#include <fmt/format.h>

namespace breccia {

std::string text_if_known(const std::optional<double>& number) {
  return number ? fmt::format("{}", *number) : "";
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

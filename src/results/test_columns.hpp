#pragma once

#include <string>
#include <vector>

#include "breccia/study/test_id.hpp"

#include "tables/csv.hpp"

namespace breccia {

/// The columns of a table with the stage and the test of each row.
struct TestColumns {
  std::vector<std::string> stages, loads, boundaries, methods, cells;

  /// Adds a row.
  void add(const std::string& stage, const TestId& test);
  /// Adds the columns to a table.
  void append_to(std::vector<CsvColumn>& table) const;
};

}  // namespace breccia

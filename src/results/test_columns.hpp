#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "breccia/study/test_id.hpp"

#include "tables/csv.hpp"

namespace breccia {

/// A number of a table with all its digits; empty where it is not known.
std::string text_if_known(const std::optional<double>& number);
/// The number that text_if_known() has written into a column of texts. Throws FileError for other texts.
std::optional<double> number_if_known(const CsvTable& table, const std::string& column, std::size_t row);

/// The identity of the test to which a row of a table of samples belongs. The table of extrapolated curves has no
/// column of grids, that of comparisons none of loads. Throws FileError where a word is not as `breccia run` writes it.
TestId id_of_row(const CsvTable& table, std::size_t row);

/// The columns of a table with the stage and the test of each row.
struct TestColumns {
  std::vector<std::string> stages, loads, boundaries, methods, cells;

  /// Adds a row.
  void add(const std::string& stage, const TestId& test);
  /// Adds the columns to a table.
  void append_to(std::vector<CsvColumn>& table) const;
};

}  // namespace breccia

#pragma once

#include <vector>

namespace breccia::quasistatic {

/// Entries of a sparse matrix, by row and column. Entries at the same place add up.
struct MatrixEntries {
  std::vector<int> rows, columns;
  std::vector<double> values;

  void add(int row, int column, double value) {
    rows.push_back(row);
    columns.push_back(column);
    values.push_back(value);
  }
};

}  // namespace breccia::quasistatic

#pragma once

#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"

#include "tables/csv.hpp"

namespace breccia {

/// The columns of a table with a complex modulus of each row: against the angular frequency and the frequency, by its
/// parts and by its size and phase, with its error.
class ComplexColumns {
 public:
  /// Adds a row.
  void add(const ComplexSample& sample);
  [[nodiscard]] bool empty() const { return angular_frequencies_.empty(); }
  /// Adds the columns to a table.
  void append_to(std::vector<CsvColumn>& table) const;

 private:
  std::vector<double> angular_frequencies_, frequencies_, storage_, loss_, loss_tangents_, sizes_, phases_;
  std::vector<std::string> errors_;
};

}  // namespace breccia

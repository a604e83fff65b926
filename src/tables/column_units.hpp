#pragma once

#include "tables/column_meaning.hpp"

namespace breccia::detail {

/// SI value = value * factor / divisor + offset. Either the factor or the divisor is 1, so that 7 in um becomes exactly
/// the same number as 7e-6 in m.
struct Conversion {
  double factor = 1.0;
  double divisor = 1.0;
  double offset = 0.0;

  [[nodiscard]] double operator()(double value) const;
};

/// The conversion of the values of a column to the unit of its quantity. Throws InputError if the unit is unknown.
Conversion conversion_of(const ColumnMeaning& meaning);

}  // namespace breccia::detail

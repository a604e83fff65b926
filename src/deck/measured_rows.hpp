#pragma once

#include <cstddef>
#include <vector>

#include "breccia/tables/measured_table.hpp"

namespace breccia {

/// Throws InputError with all values that are not positive and finite, since the fits use their logarithms, and with
/// phase angles that no solid has.
void require_positive(const MeasuredTable& table, const std::vector<const MeasuredColumn*>& columns);

/// The indices of the rows, sorted by rising values of a column.
std::vector<std::size_t> rising_rows(const std::vector<double>& column);

/// The values of a column in the order of these rows.
std::vector<double> in_order(const std::vector<double>& column, const std::vector<std::size_t>& rows);

}  // namespace breccia

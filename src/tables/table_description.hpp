#pragma once

#include <string>

#include "breccia/tables/measured_table.hpp"

namespace breccia {

/// A description of a table as it was read, for users to check: its layout, each recognised column with its unit and
/// the range of its numbers, and the names of the columns that are not read. Several lines, the last one without a line
/// break.
std::string description_of(const MeasuredTable& table);

}  // namespace breccia

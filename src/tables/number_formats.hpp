#pragma once

#include <cstdint>
#include <vector>

#include <pugixml.hpp>

namespace breccia::detail {

/// What the format of a cell of a workbook shows of a stored number.
enum class NumberFormat : std::uint8_t {
  number,     ///< the number itself
  date,       ///< a date or a time of day, of which days are stored
  scaled,     ///< the number in thousands or millions
  percentage  ///< a hundred times the number
};

/// The formats of the styles of a workbook, from the root of its part styles.xml, in the order by which cells refer to
/// them (Office Open XML, ECMA-376, Part 1, 18.8.30 and 18.8.31); none for an empty node.
std::vector<NumberFormat> number_formats(const pugi::xml_node& styles);

}  // namespace breccia::detail

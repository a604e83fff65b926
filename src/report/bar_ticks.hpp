#pragma once

#include <string>
#include <vector>

#include "report/colour_range.hpp"

namespace breccia {

/// A mark at a colour bar.
struct BarTick {
  double share;  ///< position on the bar, 0 at its lowest colour and 1 at its highest
  std::string label;
};

/// Marks at round values of a range of colours, rising: on a linear scale some five in steps of 1, 2 or 5 times a power
/// of ten, on a logarithmic one at the powers of ten, with 2 and 5 times these where they would be few. The labels are
/// the values in units of `unit_size`.
std::vector<BarTick> bar_ticks(const ColourRange& colours, double unit_size);

}  // namespace breccia

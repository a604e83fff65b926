#pragma once

#include <string>
#include <vector>

namespace breccia {

/// A mark on an axis: long with a label, or short without.
struct Tick {
  double at;
  std::string label;     ///< "0.2", "500"; the base and its factor where there is a power: "10", "2×10"
  std::string exponent;  ///< exponent of a power of ten; empty for other labels
};

/// A logarithmic axis from begin to end.
struct LogAxis {
  double begin;
  double end;
  std::vector<Tick> ticks;  ///< ticks in rising order; two to ten of them have a label
};

/// The axis for positive values from smallest to largest, widened by a factor on both sides. It spans at least a factor
/// of four.
LogAxis log_axis(double smallest, double largest, double margin = 1.0);

}  // namespace breccia

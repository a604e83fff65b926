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

enum class AxisScale { linear, logarithmic };

/// An axis from begin to end.
struct PlotAxis {
  double begin;
  double end;
  AxisScale scale;
  std::vector<Tick> ticks;  ///< ticks in rising order; two to ten of them have a label

  /// The place of a value, 0 at the begin and 1 at the end.
  [[nodiscard]] double share(double value) const;
};

/// The axis for positive values from smallest to largest, widened by a factor on both sides. It spans at least a factor
/// of four.
PlotAxis log_axis(double smallest, double largest, double margin = 1.0);

/// The axis for values from smallest to largest, which differ, with some five ticks at round values.
PlotAxis linear_axis(double smallest, double largest);

}  // namespace breccia

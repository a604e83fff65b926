#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/plot_axis.hpp"

namespace breccia {

/// The style of a curve in a plot.
enum class PlotStyle {
  line,
  dashed,
  dotted,
  points,  ///< marks alone, for measured values
  line_and_points
};

/// One curve of modulus against time, or of the other quantities that the axes of its plot name.
struct PlotCurve {
  std::string label;
  std::vector<double> times = {};   ///< [s]
  std::vector<double> moduli = {};  ///< [Pa], as many as times
  PlotStyle style = PlotStyle::line;
  std::optional<std::size_t> colour = {};  ///< index in the palette, to share a colour; the next one by default
};

/// A span of time marked as a band behind the curves, such as the valid window of a time domain.
struct PlotWindow {
  std::string label;
  double begin;  ///< [s]
  double end;    ///< [s]
};

/// A plot of moduli against time on logarithmic axes. With other labels on the axes it can show compliances, or moduli
/// against frequency or, on a linear axis, against a fraction.
struct ModulusPlot {
  std::string title;
  std::vector<PlotCurve> curves;
  std::vector<PlotWindow> windows = {};
  std::string quantity = "Relaxation modulus";
  std::string unit = "MPa";  ///< unit of the axis; empty without one
  double unit_size = 1e6;    ///< that unit in the SI unit of the values
  std::string abscissa = "Time / s";
  AxisScale abscissa_scale = AxisScale::logarithmic;
};

/// SVG of a plot. Points that its axes cannot show (not finite, or not positive on a logarithmic axis) are left out.
/// Throws InputError if a curve has not as many moduli as times or if no point is left.
std::string modulus_plot(const ModulusPlot& plot);

}  // namespace breccia

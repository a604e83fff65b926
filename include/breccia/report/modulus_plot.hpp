#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace breccia {

/// How a curve of a plot is drawn.
enum class PlotStyle {
  line,
  dashed,
  dotted,
  points,  ///< marks alone, for measured values
  line_and_points
};

/// One curve of modulus against time, or of what else the axes of its plot say.
struct PlotCurve {
  std::string label;
  std::vector<double> times = {};   ///< [s]
  std::vector<double> moduli = {};  ///< [Pa], as many as times
  PlotStyle style = PlotStyle::line;
  std::optional<std::size_t> colour = {};  ///< place in the palette, for curves to share one; by default the next
};

/// A span of time marked as a band behind the curves, such as the valid window of a time domain.
struct PlotWindow {
  std::string label;
  double begin;  ///< [s]
  double end;    ///< [s]
};

/// A plot of moduli against time on logarithmic axes; with other words on its axes, of compliances or against
/// frequency.
struct ModulusPlot {
  std::string title;
  std::vector<PlotCurve> curves;
  std::vector<PlotWindow> windows = {};
  std::string quantity = "Relaxation modulus";
  std::string unit = "MPa";  ///< that the axis is labelled with
  double unit_size = 1e6;    ///< in the SI unit of the values
  std::string abscissa = "Time / s";
};

/// SVG of a plot, drawn by gnuplot. Points that logarithmic axes cannot show (time or modulus not positive and finite)
/// are left out. Throws InputError if a curve has not as many moduli as times or if nothing is left to show,
/// and FileError if gnuplot is missing or fails.
std::string modulus_plot(const ModulusPlot& plot);

/// Writes such a plot to a file. Where gnuplot cannot draw it, returns why, and no file of that name is left: results
/// are whole without their plots. Throws InputError as above, and FileError where the file cannot be written.
std::optional<std::string> write_modulus_plot(const std::filesystem::path& file, const ModulusPlot& plot);

/// Why gnuplot cannot draw, and what to install; nothing where it can. For results whose plots can be left out.
std::optional<std::string> why_no_plots();

}  // namespace breccia

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "report/modulus_plot.hpp"

namespace breccia {

/// A place in a drawing.
struct PlotPoint {
  double x;
  double y;
};

/// The pen with which a curve and its sample in the legend are drawn.
struct PlotPen {
  std::string_view colour;
  std::string_view dashes;  ///< dashes of the line, as the attribute of SVG; empty for a line without gaps
  bool has_line;
  bool has_marks;  ///< whether small circles are drawn at the points
};

/// The pen of a curve. Curves of one colour differ by their dashes: each round of the palette has its own.
PlotPen pen_of(PlotStyle style, std::size_t colour);

/// A line through some points, with circles at others.
std::string drawn_by(const PlotPen& pen, const std::vector<PlotPoint>& line, const std::vector<PlotPoint>& marks);

}  // namespace breccia

#pragma once

#include <string>
#include <string_view>

#include "report/plot_axis.hpp"

namespace breccia {

/// The rectangle of a plot within its axes. Lengths are in units of the drawing, with y downwards.
struct PlotArea {
  double left = 0.0;
  double right = 0.0;
  double top = 0.0;
  double bottom = 0.0;
  PlotAxis abscissa;
  PlotAxis ordinate;

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
  [[nodiscard]] double x(double value) const;
  [[nodiscard]] double y(double value) const;
};

/// The lines of a grid at all ticks.
std::string grid_of(const PlotArea& area);

/// The frame, the ticks with their labels, and the names of both axes.
std::string axes_of(const PlotArea& area, std::string_view abscissa, std::string_view ordinate);

}  // namespace breccia

#pragma once

#include <string>
#include <vector>

#include "report/plot_pen.hpp"

namespace breccia {

/// One line of a legend: a sample of the pen, and the label.
struct LegendEntry {
  PlotPen pen;
  std::string label;
};

/// A legend as columns of equal width, filled row by row, in the middle of a picture.
class PlotLegend {
 public:
  PlotLegend(std::vector<LegendEntry> entries, double width_of_picture);

  [[nodiscard]] double height() const;
  /// The elements of the legend, whose upper side is at y.
  [[nodiscard]] std::string drawn_at(double y) const;

 private:
  std::vector<LegendEntry> entries_;
  double width_of_picture_;
  double width_of_column_;
  std::size_t columns_;
};

}  // namespace breccia

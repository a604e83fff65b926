#include "report/modulus_plot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "report/markup.hpp"
#include "report/plot_area.hpp"
#include "report/plot_axis.hpp"
#include "report/plot_legend.hpp"
#include "report/plot_pen.hpp"
#include "report/plot_text.hpp"

namespace breccia {

namespace {

constexpr double picture_width = 900.0;
constexpr double left_of_area = 102.0, right_of_area = 870.0, height_of_area = 420.0;
constexpr double above_area = 18.0, title_above_area = 46.0;
constexpr double below_area = 68.0;  // labels at the ticks and the name of the axis
constexpr double below_legend = 14.0;
constexpr double row_of_windows = 16.0;  // height of a row of their labels

/// Whether an axis can show a value.
bool can_show(AxisScale scale, double value) {
  return std::isfinite(value) && (scale == AxisScale::linear || value > 0.0);
}

/// The points of a curve that the axes of a plot can show, and their values [s, unit of the plot].
std::vector<PlotPoint> visible_points(const ModulusPlot& plot, const PlotCurve& curve) {
  if (curve.times.size() != curve.moduli.size()) {
    throw InputError(fmt::format("plot: the curve \"{}\" has {} times but {} moduli", curve.label, curve.times.size(),
                                 curve.moduli.size()));
  }
  std::vector<PlotPoint> points;
  for (std::size_t i = 0; i < curve.times.size(); ++i) {
    if (can_show(plot.abscissa_scale, curve.times[i]) && can_show(AxisScale::logarithmic, curve.moduli[i])) {
      points.push_back({curve.times[i], curve.moduli[i] / plot.unit_size});
    }
  }
  return points;
}

/// A curve that has points to show.
struct VisibleCurve {
  std::string label;
  PlotPen pen;
  std::vector<PlotPoint> points;  ///< values [s, unit of the plot]
};

std::vector<VisibleCurve> visible_curves(const ModulusPlot& plot) {
  std::vector<VisibleCurve> curves;
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const auto& curve = plot.curves[i];
    auto points = visible_points(plot, curve);
    if (points.empty()) continue;
    curves.push_back({curve.label, pen_of(curve.style, curve.colour.value_or(i)), std::move(points)});
  }
  if (curves.empty()) throw InputError(fmt::format("plot \"{}\": there is no point to show", plot.title));
  return curves;
}

/// The part of a window that the axis of times shows, and the position of its label in the drawing.
struct Band {
  std::string label;
  double begin;
  double end;
  double middle_of_label;
  std::size_t row;  ///< row of the label, from the top: the first row in which it does not touch the label before
};

std::vector<Band> bands_of(const std::vector<PlotWindow>& windows, const PlotArea& area) {
  std::vector<Band> bands;
  std::vector<double> ends_of_rows;
  for (const auto& [label, begin, end] : windows) {
    const double from = area.x(std::clamp(begin, area.abscissa.begin, area.abscissa.end));
    const double to = area.x(std::clamp(end, area.abscissa.begin, area.abscissa.end));
    if (!(from < to)) continue;
    const double half_width = 0.5 * std::min(plot_text_width(label, small_plot_font_size), area.width());
    const double middle = std::clamp(0.5 * (from + to), area.left + half_width, area.right - half_width);
    const auto row = std::ranges::find_if(ends_of_rows, [&](double taken) { return taken <= middle - half_width; });
    bands.push_back({label, from, to, middle, static_cast<std::size_t>(row - ends_of_rows.begin())});
    if (row == ends_of_rows.end()) {
      ends_of_rows.push_back(middle + half_width);
    } else {
      *row = middle + half_width;
    }
  }
  return bands;
}

std::size_t rows_of(const std::vector<Band>& bands) {
  std::size_t rows = 0;
  for (const auto& band : bands) rows = std::max(rows, band.row + 1);
  return rows;
}

/// Transparent bands of alternating colour: where two windows overlap both can be seen.
std::string drawn_bands(const std::vector<Band>& bands, const PlotArea& area) {
  std::string svg;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    svg += fmt::format(
        "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\" fill-opacity=\"0.12\"/>\n",
        bands[i].begin, area.top, bands[i].end - bands[i].begin, area.height(), i % 2 == 0 ? "#4477aa" : "#998866");
  }
  return svg;
}

std::string labels_of(const std::vector<Band>& bands, const PlotArea& area) {
  if (bands.empty()) return "";
  std::string labels;
  for (const auto& band : bands) {
    labels += plot_text(band.middle_of_label, area.top + row_of_windows * static_cast<double>(band.row + 1), band.label,
                        area.width(), "", small_plot_font_size);
  }
  return fmt::format("<g font-size=\"{:g}\" fill=\"#606060\" text-anchor=\"middle\">\n{}</g>\n", small_plot_font_size,
                     labels);
}

/// Axes that show all curves, with room for the labels of the windows above them.
struct Layout {
  PlotArea area;
  std::vector<Band> bands;
};

Layout layout_of(const ModulusPlot& plot, const std::vector<VisibleCurve>& curves) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  PlotPoint smallest{infinity, infinity}, largest{-infinity, -infinity};
  for (const auto& curve : curves) {
    for (const auto& [time, modulus] : curve.points) {
      smallest = {std::min(smallest.x, time), std::min(smallest.y, modulus)};
      largest = {std::max(largest.x, time), std::max(largest.y, modulus)};
    }
  }
  const double top = plot.title.empty() ? above_area : title_above_area;
  auto abscissa =
      plot.abscissa_scale == AxisScale::linear ? linear_axis(smallest.x, largest.x) : log_axis(smallest.x, largest.x);
  PlotArea area{left_of_area, right_of_area, top, top + height_of_area, std::move(abscissa), {}};
  auto bands = bands_of(plot.windows, area);

  constexpr double widening = 1.3;
  const double range = widening * widening * largest.y / smallest.y;
  const double share_of_labels = row_of_windows * static_cast<double>(rows_of(bands)) / height_of_area;
  const double headroom = std::pow(range, share_of_labels / (1.0 - share_of_labels));
  area.ordinate = log_axis(smallest.y, largest.y * headroom, widening);
  return {std::move(area), std::move(bands)};
}

std::string drawn_curves(const std::vector<VisibleCurve>& curves, const PlotArea& area) {
  std::string svg;
  for (const auto& curve : curves) {
    std::vector<PlotPoint> places;
    places.reserve(curve.points.size());
    for (const auto& [time, modulus] : curve.points) places.push_back({area.x(time), area.y(modulus)});
    svg += drawn_by(curve.pen, places, places);
  }
  return fmt::format("<g fill=\"none\" stroke-linejoin=\"round\">\n{}</g>\n", svg);
}

PlotLegend legend_of(const std::vector<VisibleCurve>& curves) {
  std::vector<LegendEntry> entries;
  for (const auto& curve : curves) {
    if (!curve.label.empty()) entries.push_back({curve.pen, curve.label});
  }
  return {std::move(entries), picture_width};
}

std::string drawn_title(const std::string& title, const PlotArea& area) {
  if (title.empty()) return "";
  return plot_text(0.5 * (area.left + area.right), 0.6 * area.top, title, area.width(), "text-anchor=\"middle\"");
}

}  // namespace

std::string modulus_plot(const ModulusPlot& plot) {
  const auto curves = visible_curves(plot);
  const auto [area, bands] = layout_of(plot, curves);
  const auto legend = legend_of(curves);
  const double top_of_legend = area.bottom + below_area;
  const double height = top_of_legend + legend.height() + below_legend;
  const auto ordinate = plot.unit.empty() ? plot.quantity : fmt::format("{} / {}", plot.quantity, plot.unit);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:g} {:g}\" font-family=\"sans-serif\" "
             "font-size=\"{:g}\">\n<rect width=\"{:g}\" height=\"{:g}\" fill=\"#ffffff\"/>\n",
             picture_width, height, plot_font_size, picture_width, height) +
         drawn_bands(bands, area) + grid_of(area) + labels_of(bands, area) + axes_of(area, plot.abscissa, ordinate) +
         drawn_curves(curves, area) + drawn_title(plot.title, area) + legend.drawn_at(top_of_legend) + "</svg>\n";
}

}  // namespace breccia

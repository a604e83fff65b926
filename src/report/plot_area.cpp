#include "report/plot_area.hpp"

#include <fmt/format.h>

#include "report/plot_text.hpp"

namespace breccia {
namespace {

constexpr double long_tick = 10.0, short_tick = 5.0;
constexpr double exponent_size = 0.8;  // size of an exponent as a share of the size of the label
constexpr double x_of_name = 24.0;     // position of the name of the ordinate, left of the longest labels

double length_of(const Tick& tick) {
  return tick.label.empty() ? short_tick : long_tick;
}

/// The label of a tick, its exponent raised.
std::string label_of(const Tick& tick, double x, double y, std::string_view anchor) {
  if (tick.label.empty()) return "";
  const auto exponent = tick.exponent.empty() ? ""
                                              : fmt::format(R"(<tspan dy="-7" font-size="{:g}">{}</tspan>)",
                                                            exponent_size * plot_font_size, tick.exponent);
  return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\">{}{}</text>\n", x, y, anchor, tick.label,
                     exponent);
}

}  // namespace

double PlotArea::x(double value) const {
  return left + abscissa.share(value) * width();
}

double PlotArea::y(double value) const {
  return bottom - ordinate.share(value) * height();
}

std::string grid_of(const PlotArea& area) {
  std::string labelled, others;
  for (const auto& tick : area.abscissa.ticks) {
    (tick.label.empty() ? others : labelled) +=
        fmt::format("M{:.2f} {:.2f}V{:.2f}", area.x(tick.at), area.bottom, area.top);
  }
  for (const auto& tick : area.ordinate.ticks) {
    (tick.label.empty() ? others : labelled) +=
        fmt::format("M{:.2f} {:.2f}H{:.2f}", area.left, area.y(tick.at), area.right);
  }
  return fmt::format("<g fill=\"none\" stroke=\"#ececec\"><path d=\"{}\"/><path stroke=\"#cfcfcf\" d=\"{}\"/></g>\n",
                     others, labelled);
}

std::string axes_of(const PlotArea& area, std::string_view abscissa, std::string_view ordinate) {
  std::string marks, labels;
  for (const auto& tick : area.abscissa.ticks) {
    const double x = area.x(tick.at);
    marks += fmt::format("M{:.2f} {:.2f}v{:g}", x, area.bottom, length_of(tick));
    labels += label_of(tick, x, area.bottom + 28.0, "middle");
  }
  for (const auto& tick : area.ordinate.ticks) {
    const double y = area.y(tick.at);
    marks += fmt::format("M{:.2f} {:.2f}h{:g}", area.left, y, -length_of(tick));
    labels += label_of(tick, area.left - long_tick - 5.0, y + middle_of_plot_text, "end");
  }
  const double y_of_name = 0.5 * (area.top + area.bottom);
  return fmt::format(
             "<path fill=\"none\" stroke=\"#404040\" d=\"M{:.2f} {:.2f}H{:.2f}V{:.2f}H{:.2f}Z{}\"/>\n<g "
             "fill=\"#404040\">\n{}</g>\n",
             area.left, area.top, area.right, area.bottom, area.left, marks, labels) +
         plot_text(0.5 * (area.left + area.right), area.bottom + 52.0, abscissa, area.width(),
                   "text-anchor=\"middle\"") +
         plot_text(x_of_name, y_of_name, ordinate, area.height(),
                   fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 {:.2f} {:.2f})\"", x_of_name, y_of_name));
}

}  // namespace breccia

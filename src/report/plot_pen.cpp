#include "report/plot_pen.hpp"

#include <array>
#include <iterator>

#include <fmt/format.h>

namespace breccia {
namespace {

/// Colours that remain distinct to the colour-blind (Okabe and Ito, 2008), without the yellow, which is lost on white.
constexpr std::array<std::string_view, 7> plot_palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                       "#e69f00", "#56b4e9", "#000000"};

/// Dashes of lines, and of lines for lower bounds, in each round of the palette.
constexpr std::array<std::string_view, 4> line_dashes{"", "18 6 4 6", "18 6 4 6 4 6", "40 6"};
constexpr std::array<std::string_view, 4> lower_dashes{"10 6", "5 7", "12 6 3 6", "12 6 3 6 3 6"};

}  // namespace

PlotPen pen_of(PlotStyle style, std::size_t colour) {
  const auto round = colour / plot_palette.size();
  const auto plain = line_dashes[round % line_dashes.size()];
  PlotPen pen{plot_palette[colour % plot_palette.size()], plain, true, false};
  switch (style) {
    case PlotStyle::line:
      break;
    case PlotStyle::dashed:
      pen.dashes = lower_dashes[round % lower_dashes.size()];
      break;
    case PlotStyle::dotted:
      pen.dashes = "2 4";
      break;
    case PlotStyle::points:
      pen.has_line = false;
      pen.has_marks = true;
      break;
    case PlotStyle::line_and_points:
      pen.has_marks = true;
      break;
  }
  return pen;
}

std::string drawn_by(const PlotPen& pen, const std::vector<PlotPoint>& line, const std::vector<PlotPoint>& marks) {
  std::string svg;
  if (pen.has_line && !line.empty()) {
    std::string path;
    for (const auto& [x, y] : line) {
      fmt::format_to(std::back_inserter(path), "{}{:.2f} {:.2f}", path.empty() ? "M" : "L", x, y);
    }
    const auto dashes = pen.dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", pen.dashes);
    svg += fmt::format("<path stroke=\"{}\" stroke-width=\"2\"{} d=\"{}\"/>\n", pen.colour, dashes, path);
  }
  if (pen.has_marks) {
    svg += fmt::format("<g stroke=\"{}\">", pen.colour);
    for (const auto& [x, y] : marks) {
      fmt::format_to(std::back_inserter(svg), R"(<circle cx="{:.2f}" cy="{:.2f}" r="4"/>)", x, y);
    }
    svg += "</g>\n";
  }
  return svg;
}

}  // namespace breccia

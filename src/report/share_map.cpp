#include "report/share_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>

#include "report/plot_text.hpp"

namespace breccia {
namespace {

constexpr double picture_width = 900.0, margin = 18.0;
constexpr double height_of_row = 30.0, height_of_title = 34.0, height_of_labels = 30.0;
constexpr double widest_name = 300.0;

/// A share as a blue on white.
std::string colour_of(double share) {
  const auto part = [share](double full) {
    constexpr double white = 255.0;
    return static_cast<int>(std::lround(std::lerp(white, full, std::clamp(share, 0.0, 1.0))));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", part(33.0), part(96.0), part(160.0));
}

double width_of_names(const std::vector<std::string>& rows) {
  double width = 0.0;
  for (const auto& row : rows) width = std::max(width, plot_text_width(row));
  return std::min(width, widest_name);
}

}  // namespace

std::string share_map(const ShareMap& map) {
  const double names = width_of_names(map.rows);
  const double left = 2.0 * margin + names;
  const double cell =
      (picture_width - left - margin) / static_cast<double>(std::max<std::size_t>(map.columns.size(), 1));
  const double bottom = height_of_title + height_of_row * static_cast<double>(map.rows.size());
  const double height = bottom + height_of_labels;
  auto svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:g} {:g}\" font-family=\"sans-serif\" "
      "font-size=\"{:g}\">\n<rect width=\"{:g}\" height=\"{:g}\" fill=\"#ffffff\"/>\n",
      picture_width, height, plot_font_size, picture_width, height);
  svg += plot_text(0.5 * picture_width, 0.65 * height_of_title, map.title, picture_width, "text-anchor=\"middle\"");
  for (std::size_t row = 0; row < map.rows.size(); ++row) {
    const double top = height_of_title + height_of_row * static_cast<double>(row);
    const double base = top + 0.5 * height_of_row + middle_of_plot_text;
    svg += plot_text(left - 0.5 * margin, base, map.rows[row], names, "text-anchor=\"end\"");
    for (std::size_t column = 0; column < map.columns.size(); ++column) {
      constexpr double light = 0.5;
      const double share = map.shares[row][column], x = left + cell * static_cast<double>(column);
      svg += fmt::format(
          "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\" stroke=\"#ffffff\"/>\n", x,
          top, cell, height_of_row, colour_of(share));
      svg += plot_text(x + 0.5 * cell, base, fmt::format("{:.0f}", 100.0 * share), cell,
                       fmt::format(R"(font-size="{:g}" text-anchor="middle"{})", small_plot_font_size,
                                   share > light ? R"( fill="#ffffff")" : ""),
                       small_plot_font_size);
    }
  }
  for (std::size_t column = 0; column < map.columns.size(); ++column) {
    svg += plot_text(
        left + cell * (static_cast<double>(column) + 0.5), bottom + 0.6 * height_of_labels, map.columns[column], cell,
        fmt::format(R"(font-size="{:g}" text-anchor="middle")", small_plot_font_size), small_plot_font_size);
  }
  return svg + "</svg>\n";
}

}  // namespace breccia

#include "report/map_frame.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

#include "io/display.hpp"
#include "report/bar_ticks.hpp"
#include "report/embedded_png.hpp"
#include "report/markup.hpp"
#include "report/picture_frame.hpp"

namespace breccia {
namespace {

/// The colours of the bar from its top.
std::string encoded_bar(const ColourRange& colours) {
  std::vector<std::uint8_t> pixels(256);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i] =
        colours.index_of(colours.value_at(1.0 - static_cast<double>(i) / (static_cast<double>(pixels.size()) - 1.0)));
  }
  return embedded_png(1, pixels, colours.colours());
}

/// The attributes that move an element to the position of a map; empty at the origin of the picture.
std::string place_of_map(const PlacedMap& map) {
  return map.x == 0.0 && map.y == 0.0 ? std::string() : fmt::format(R"(x="{}" y="{}" )", map.x, map.y);
}

std::string drawn_map(const PlacedMap& map) {
  const auto place = place_of_map(map);
  auto svg = fmt::format(
      R"svg(<image {0}width="{1}" height="{1}" preserveAspectRatio="none" style="image-rendering: pixelated" href="{2}"/>
<rect {0}width="{1}" height="{1}" fill="none" stroke="#222" stroke-width="2"/>
)svg",
      place, map.side, map.image);
  if (!map.outlines.empty()) {
    svg += fmt::format(
        "<path transform=\"translate({} {}) scale({})\" d=\"{}\" fill=\"none\" stroke=\"#000\" "
        "stroke-opacity=\"0.55\" stroke-width=\"1.2\" vector-effect=\"non-scaling-stroke\"/>\n",
        map.x, map.y, map.side, map.outlines);
  }
  if (map.caption.empty()) return svg;
  return svg + fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"26\" fill=\"#222\">{}</text>\n", map.x, map.y - 10.0,
                           as_markup(map.caption));
}

/// The corners of the unit square, from the lower left one on, after a load; y upwards.
std::array<std::array<double, 2>, 4> deformed(DrawnLoad load) {
  constexpr double size = 0.25;
  switch (load) {
    case DrawnLoad::shear:
      return {{{0.0, 0.0}, {1.0, 0.0}, {1.0 + size, 1.0}, {size, 1.0}}};
    case DrawnLoad::stretch:
      return {{{-0.5 * size, 0.5 * size},
               {1.0 + 0.5 * size, 0.5 * size},
               {1.0 + 0.5 * size, 1.0 - 0.5 * size},
               {-0.5 * size, 1.0 - 0.5 * size}}};
    case DrawnLoad::dilatation:
      return {{{-0.5 * size, -0.5 * size},
               {1.0 + 0.5 * size, -0.5 * size},
               {1.0 + 0.5 * size, 1.0 + 0.5 * size},
               {-0.5 * size, 1.0 + 0.5 * size}}};
    case DrawnLoad::none:
      break;
  }
  return {};
}

/// The load as a small picture: the undeformed square, dashed, and the deformed one.
std::string drawn_load(DrawnLoad load) {
  if (load == DrawnLoad::none) return {};
  constexpr double left = 900.0, bottom = 1140.0, side = 64.0;
  std::string path;
  for (const auto& [x, y] : deformed(load)) {
    path += fmt::format("{}{:.6g} {:.6g}", path.empty() ? "M" : "L", left + side * x, bottom - side * y);
  }
  return fmt::format(
      R"svg(<text x="884" y="1122" font-size="30" fill="#222" text-anchor="end">load:</text>
<path d="M{0} {1}h{2}v-{2}h-{2}z" fill="none" stroke="#222" stroke-width="1.5" stroke-dasharray="6 5"/>
<path d="{3}z" fill="none" stroke="#222" stroke-width="3"/>
)svg",
      left, bottom, side, path);
}

/// A scale bar of a round length, for a map of this side in units of the drawing.
std::string drawn_scale_bar(double side, double drawn) {
  if (!(side > 0.0)) return {};
  const double length = scale_bar_length(side);
  const double width = length / side * drawn;
  return fmt::format(R"svg(<rect id="scale-bar" y="1100" width="{0:.6g}" height="10" fill="#222"/>
<text x="{1:.6g}" y="1118" font-size="34" fill="#222">{2}</text>
)svg",
                     width, width + 18.0, with_micro_sign(length));
}

}  // namespace

std::string framed_maps(const MapWords& words, const std::vector<PlacedMap>& maps, const std::vector<double>& values,
                        const ColourRange& colours) {
  const auto written = [&](double value) { return three_digits(value / words.unit_size); };
  const auto [lowest, highest] = std::ranges::minmax(values);

  std::string svg;
  const auto out = std::back_inserter(svg);
  std::string drawn_maps;
  for (const auto& map : maps) drawn_maps += drawn_map(map);
  // The bar is to the right of the maps.
  fmt::format_to(
      out,
      R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="-20 -70 1290 1240" font-family="sans-serif" role="img" aria-labelledby="title">
<title id="title">{0}</title>
<rect x="-20" y="-70" width="1290" height="1240" fill="#fff"/>
<text y="-24" font-size="34" fill="#222">{0}</text>
{1}<image x="1030" width="40" height="1000" preserveAspectRatio="none" href="{2}"/>
<rect x="1030" width="40" height="1000" fill="none" stroke="#222" stroke-width="2"/>
)svg",
      as_markup(words.title), drawn_maps, encoded_bar(colours));
  for (const auto& [share, label] : bar_ticks(colours, words.unit_size)) {
    const double y = 1000.0 * (1.0 - share);
    fmt::format_to(out, R"svg(<path d="M1070 {0:.6g}h10" stroke="#222" stroke-width="2"/>
<text x="1086" y="{1:.6g}" font-size="30" fill="#222">{2}</text>
)svg",
                   y, y + 11.0, label);
  }
  fmt::format_to(
      out,
      R"svg(<text transform="translate(1240 500) rotate(-90)" font-size="30" fill="#222" text-anchor="middle">{0}</text>
<text y="1046" font-size="30" fill="#222">{0}; it goes from {1} to {2}</text>
{3}{4}</svg>
)svg",
      as_markup(words.quantity), written(lowest), written(highest), drawn_scale_bar(words.side, maps.front().side),
      drawn_load(words.load));
  return svg;
}

}  // namespace breccia

#include "map_frame.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

#include "breccia/io/display.hpp"

#include "colour_map.hpp"
#include "embedded_png.hpp"
#include "markup.hpp"

namespace breccia {
namespace {

std::string encoded_bar() {
  std::vector<std::uint8_t> pixels(256);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint8_t>(255 - i);
  return embedded_png(1, pixels, perceptual_colours());
}

/// The place of an element, nothing for that of the picture.
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
  if (map.caption.empty()) return svg;
  return svg + fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"26\" fill=\"#222\">{}</text>\n", map.x, map.y - 10.0,
                           as_markup(map.caption));
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
      R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="-20 -70 1240 1150" font-family="sans-serif" role="img" aria-labelledby="title">
<title id="title">{0}</title>
<rect x="-20" y="-70" width="1240" height="1150" fill="#fff"/>
<text y="-24" font-size="34" fill="#222">{0}</text>
{1}<image x="1030" width="40" height="1000" preserveAspectRatio="none" href="{2}"/>
<rect x="1030" width="40" height="1000" fill="none" stroke="#222" stroke-width="2"/>
)svg",
      as_markup(words.title), drawn_maps, encoded_bar());
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double y = 1000.0 * (1.0 - share);
    fmt::format_to(out, R"svg(<path d="M1070 {0}h10" stroke="#222" stroke-width="2"/>
<text x="1086" y="{1}" font-size="30" fill="#222">{2}</text>
)svg",
                   y, y + 11.0, written(colours.value_at(share)));
  }
  fmt::format_to(out, R"svg(<text y="1046" font-size="30" fill="#222">{}; it goes from {} to {}</text>
</svg>
)svg",
                 as_markup(words.quantity), written(lowest), written(highest));
  return svg;
}

}  // namespace breccia

#include "report/field_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "report/colour_range.hpp"
#include "report/embedded_png.hpp"
#include "report/map_frame.hpp"
#include "report/map_means.hpp"
#include "report/outlines.hpp"

namespace breccia {
namespace {

/// A square map of values.
struct Raster {
  std::size_t columns = 0;
  std::vector<double> values;
};

/// Means over equal squares, the smallest for which at most `most` columns remain; the last squares may be smaller.
Raster reduced(const std::vector<double>& values, std::size_t columns, std::size_t most) {
  MapMeans means(columns, most);
  for (const double value : values) means.add(value);
  return {means.columns(), means.values()};
}

/// The pixels row by row from the top, while the values begin at the bottom.
std::string encoded_map(const Raster& raster, const ColourRange& colours) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(raster.values.size());
  for (auto row = raster.values.size() / raster.columns; row-- > 0;) {
    for (std::size_t column = 0; column < raster.columns; ++column) {
      pixels.push_back(colours.index_of(raster.values[row * raster.columns + column]));
    }
  }
  return embedded_png(raster.columns, pixels, colours.colours());
}

void require_square(const std::vector<double>& values, std::size_t columns) {
  if (columns == 0 || values.size() != columns * columns) {
    throw InputError(
        fmt::format("picture of a field: {} values do not fill a square of {} columns", values.size(), columns));
  }
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) {
    throw InputError("picture of a field: a value is not finite");
  }
}

}  // namespace

std::string field_picture(const FieldPicture& picture) {
  require_square(picture.values, picture.columns);
  const auto raster = reduced(picture.values, picture.columns, most_map_columns);
  const auto colours = ColourRange::diverging_if_signed(picture.scale, raster.values);
  PlacedMap map{.image = encoded_map(raster, colours)};
  if (!picture.phases.empty()) {
    if (picture.phases.size() != picture.values.size()) {
      throw InputError(
          fmt::format("picture of a field: {} phases of {} values", picture.phases.size(), picture.values.size()));
    }
    map.outlines = outlines_of(picture.phases, picture.columns, most_map_columns);
  }
  return framed_maps({.title = picture.title,
                      .quantity = picture.quantity,
                      .unit_size = picture.unit_size,
                      .side = picture.side,
                      .load = picture.load},
                     {std::move(map)}, raster.values, colours);
}

std::string field_cuts_picture(const FieldCutsPicture& picture) {
  constexpr std::size_t most_columns = 300;
  std::array<Raster, 3> rasters;
  std::vector<double> values;
  for (std::size_t normal = 0; normal < rasters.size(); ++normal) {
    require_square(picture.cuts[normal], picture.columns);
    rasters[normal] = reduced(picture.cuts[normal], picture.columns, most_columns);
    values.insert(values.end(), rasters[normal].values.begin(), rasters[normal].values.end());
  }
  const ColourRange colours(picture.scale, values);
  // Two of the maps are above, and one is below on the left.
  constexpr double side = 460.0, first = 30.0, second = 530.0;
  const auto place = [&](std::size_t normal, double x, double y, const char* caption) {
    return PlacedMap{encoded_map(rasters[normal], colours), x, y, side, caption};
  };
  return framed_maps(
      {.title = picture.title, .quantity = picture.quantity, .unit_size = picture.unit_size, .side = picture.side},
      {place(2, 0.0, first, "seen along z: x to the right, y up"),
       place(0, second, first, "seen along x: y to the right, z up"),
       place(1, 0.0, second, "seen along y: z to the right, x up")},
      values, colours);
}

}  // namespace breccia

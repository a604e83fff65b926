#include "report/polygon_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "breccia/error.hpp"

#include "report/colour_range.hpp"
#include "report/embedded_png.hpp"
#include "report/map_frame.hpp"
#include "report/picture_frame.hpp"

namespace breccia {
namespace {

using Point = std::array<double, 2>;

constexpr std::size_t columns = 1000;

/// Twice the area of the triangle between three points, positive if they are counter-clockwise.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double squared_distance_from_stretch(const Point& point, const Point& from, const Point& to) {
  const double along_x = to[0] - from[0], along_y = to[1] - from[1];
  const double length = along_x * along_x + along_y * along_y;
  const double projection = (point[0] - from[0]) * along_x + (point[1] - from[1]) * along_y;
  const double share = length > 0.0 ? std::clamp(projection / length, 0.0, 1.0) : 0.0;
  const double x = point[0] - from[0] - share * along_x, y = point[1] - from[1] - share * along_y;
  return x * x + y * y;
}

/// Whether a point is in a convex polygon, counter-clockwise, or within half a unit from it.
bool covers(const std::vector<Point>& corners, const Point& point) {
  constexpr double reach = 0.5;
  bool is_inside = true;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &here = corners[i], &next = corners[(i + 1) % corners.size()];
    if (squared_distance_from_stretch(point, here, next) <= reach * reach) return true;
    if (turn(here, next, point) < 0.0) is_inside = false;
  }
  return is_inside;
}

/// The pixels of a map, row by row from the top, with the number of the polygon in each.
class Canvas {
 public:
  static constexpr std::size_t nothing = std::numeric_limits<std::size_t>::max();

  /// Draws a polygon with corners in pixels, y upwards.
  void draw(const std::vector<Point>& corners, std::size_t number) {
    const auto [left, right] = std::ranges::minmax(corners, {}, [](const Point& corner) { return corner[0]; });
    const auto [low, high] = std::ranges::minmax(corners, {}, [](const Point& corner) { return corner[1]; });
    for (auto row = first_pixel(low[1]); row < pixels_below(high[1]); ++row) {
      for (auto column = first_pixel(left[0]); column < pixels_below(right[0]); ++column) {
        const Point middle = {static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
        if (covers(corners, middle)) pixels_[(columns - 1 - row) * columns + column] = number;
      }
    }
  }
  [[nodiscard]] const std::vector<std::size_t>& pixels() const noexcept { return pixels_; }

 private:
  /// The first pixel whose middle is at most half a pixel below a coordinate, and the number of pixels whose middles
  /// are at most half a pixel above a coordinate.
  static std::size_t first_pixel(double coordinate) { return clamped(std::ceil(coordinate - 1.0)); }
  static std::size_t pixels_below(double coordinate) { return clamped(std::floor(coordinate) + 1.0); }
  static std::size_t clamped(double pixel) {
    return static_cast<std::size_t>(std::clamp(pixel, 0.0, static_cast<double>(columns)));
  }

  std::vector<std::size_t> pixels_ = std::vector<std::size_t>(columns * columns, nothing);
};

void require_sound(const PolygonPicture& picture) {
  if (!(picture.side > 0.0) || !std::isfinite(picture.side)) {
    throw InputError("picture of polygons: the side of the box is not positive and finite");
  }
  const auto is_finite = [](const MapPolygon& polygon) {
    return std::isfinite(polygon.value.value_or(0.0)) && std::ranges::all_of(polygon.corners, [](const Point& at) {
             return std::isfinite(at[0]) && std::isfinite(at[1]);
           });
  };
  if (!std::ranges::all_of(picture.polygons, is_finite)) {
    throw InputError("picture of polygons: a value or a corner is not finite");
  }
}

Canvas drawn(const PolygonPicture& picture) {
  const double scale = static_cast<double>(columns) / picture.side;
  const int images = picture.is_periodic ? 1 : 0;
  Canvas canvas;
  for (std::size_t number = 0; number < picture.polygons.size(); ++number) {
    for (int up = -images; up <= images; ++up) {
      for (int right = -images; right <= images; ++right) {
        std::vector<Point> corners;
        for (const auto& [x, y] : picture.polygons[number].corners) {
          corners.push_back({scale * (x + right * picture.side), scale * (y + up * picture.side)});
        }
        if (!corners.empty()) canvas.draw(corners, number);
      }
    }
  }
  return canvas;
}

}  // namespace

std::string polygon_picture(const PolygonPicture& picture) {
  require_sound(picture);
  const auto canvas = drawn(picture);
  const auto value_at = [&picture](std::size_t number) {
    return number == Canvas::nothing ? std::nullopt : picture.polygons[number].value;
  };
  std::vector<double> values;
  for (const auto number : canvas.pixels()) {
    if (const auto value = value_at(number)) values.push_back(*value);
  }
  if (values.empty()) throw InputError("picture of polygons: no polygon in the box has a value");
  const auto colours = ColourRange::diverging_if_signed(picture.scale, values);
  // Grey and red replace the lowest colours, which the eye cannot distinguish from the next one.
  constexpr std::uint8_t grey = 0, red = 1, lowest = 2;
  auto palette = colours.colours();
  palette[grey] = {72, 72, 72};
  palette[red] = parsed_colour(debonded_colour);
  std::vector<std::uint8_t> pixels;
  pixels.reserve(canvas.pixels().size());
  for (const auto number : canvas.pixels()) {
    const auto value = value_at(number);
    const bool is_gap = number != Canvas::nothing && picture.polygons[number].is_gap;
    pixels.push_back(value ? std::max(lowest, colours.index_of(*value)) : is_gap ? red : grey);
  }
  return framed_maps({.title = picture.title,
                      .quantity = picture.quantity,
                      .unit_size = picture.unit_size,
                      .side = picture.side,
                      .load = picture.load},
                     {{.image = embedded_png(columns, pixels, palette)}}, values, colours);
}

}  // namespace breccia

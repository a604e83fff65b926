#include "report/grain_picture.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "report/picture_frame.hpp"

namespace breccia {
namespace {

/// The corners of a grain, or of its image at this distance [m].
std::vector<Vector<2>> corners_of(const Tessellation<2>& tessellation, std::size_t grain, double film,
                                  const Vector<2>& image) {
  const auto& site = tessellation.sites().sites[grain].position;
  auto corners = polygon(tessellation.grain(grain, film));
  for (auto& corner : corners) {
    for (std::size_t axis = 0; axis < 2; ++axis) corner[axis] += site[axis] + image[axis];
  }
  return corners;
}

/// Whether the box around the corners meets the box [0, side]^2.
bool may_show(const std::vector<Vector<2>>& corners, double side) {
  if (corners.empty()) return false;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [least, most] = std::ranges::minmax(corners, {}, [axis](const auto& corner) { return corner[axis]; });
    if (most[axis] <= 0.0 || least[axis] >= side) return false;
  }
  return true;
}

}  // namespace

std::string grain_picture(const Tessellation<2>& tessellation, double film) {
  const double side = tessellation.side(), scale = picture_scale(side);
  const auto images = tessellation.walls() == Walls::periodic ? std::vector{-side, 0.0, side} : std::vector{0.0};
  std::string shapes;
  const auto out = std::back_inserter(shapes);
  for (std::size_t grain = 0; grain < tessellation.size(); ++grain) {
    for (const double dx : images) {
      for (const double dy : images) {
        const auto corners = corners_of(tessellation, grain, film, {dx, dy});
        if (!may_show(corners, side)) continue;
        fmt::format_to(out, "<polygon points=\"");
        for (const auto& [x, y] : corners) fmt::format_to(out, "{:.6g},{:.6g} ", x * scale, drawn_side - y * scale);
        fmt::format_to(out, "\"/>\n");
      }
    }
  }
  return framed_picture(side, fmt::format("{} grains", tessellation.size()), R"(fill="#5b7f95")", shapes);
}

}  // namespace breccia

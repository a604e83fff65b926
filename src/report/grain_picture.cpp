#include "report/grain_picture.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

/// The ends of a face of a cell, or of its image at this distance [m].
std::vector<Vector<2>> ends_of(const Tessellation<2>& tessellation, const CellFace<2>& face, const Vector<2>& image) {
  const auto& site = tessellation.sites().sites[face.first].position;
  const auto& cell = tessellation.cell(face.first);
  std::vector<Vector<2>> ends;
  for (const auto& [position, planes] : cell.corners()) {
    const auto is_of_face = [&](std::uint32_t plane) {
      const auto& half_space = cell.half_spaces()[plane];
      return Tessellation<2>::neighbour(half_space) == face.second && Tessellation<2>::image(half_space) == face.image;
    };
    if (!std::ranges::any_of(planes, is_of_face)) continue;
    ends.push_back({position[0] + site[0] + image[0], position[1] + site[1] + image[1]});
  }
  return ends;
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

std::string grain_picture(const Tessellation<2>& tessellation, double film, std::span<const CellFace<2>> debonded,
                          std::string_view state) {
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
  const double width = std::max(film * scale, 4.0);
  for (const auto& face : debonded) {
    for (const double dx : images) {
      for (const double dy : images) {
        const auto ends = ends_of(tessellation, face, {dx, dy});
        if (ends.size() != 2 || !may_show(ends, side)) continue;
        fmt::format_to(out, "<path d=\"M{:.6g},{:.6g}L{:.6g},{:.6g}\" stroke=\"{}\" stroke-width=\"{:.3g}\"/>\n",
                       ends[0][0] * scale, drawn_side - ends[0][1] * scale, ends[1][0] * scale,
                       drawn_side - ends[1][1] * scale, debonded_colour, width);
      }
    }
  }
  const auto in_red = debonded.empty() ? "" : fmt::format(", {} films that are {} in red,", debonded.size(), state);
  return framed_picture(side, fmt::format("{} grains{}", tessellation.size(), in_red), R"(fill="#5b7f95")", shapes);
}

}  // namespace breccia

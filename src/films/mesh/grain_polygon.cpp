#include "films/mesh/grain_polygon.hpp"

#include <cstdint>
#include <limits>

namespace breccia::films {
namespace {

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

Eigen::Vector2d to_eigen(const Vector<2>& vector) {
  return {vector[0], vector[1]};
}

/// The corners of a cell and the numbers of the half-spaces whose edges start there, counter-clockwise.
struct Outline {
  std::vector<Eigen::Vector2d> corners;
  std::vector<std::uint32_t> half_spaces;
};

Outline outline(const ConvexCell<2>& cell) {
  Outline outline;
  for (std::size_t corner = 0; outline.corners.size() < cell.corners().size(); corner = cell.corner_across(corner, 0)) {
    outline.corners.push_back(to_eigen(cell.corners()[corner].position));
    outline.half_spaces.push_back(cell.corners()[corner].planes[1]);
  }
  return outline;
}

/// A cell without its share of the films, and for each of its half-spaces the number of the half-space of the original
/// cell.
struct ErodedCell {
  ConvexCell<2> cell;
  std::vector<std::uint32_t> origin;
};

/// Erodes the cell of a site; `thickness` is the thickness of the films of the tessellation [m].
ErodedCell eroded(const Tessellation<2>& tessellation, std::size_t site, double thickness) {
  const auto& cell = tessellation.cell(site);
  ErodedCell result{cell, {}};
  const auto count = static_cast<std::uint32_t>(cell.half_spaces().size());
  for (std::uint32_t plane = 0; plane < count; ++plane) result.origin.push_back(plane);
  for (std::uint32_t plane = 0; plane < count; ++plane) {
    auto half_space = cell.half_spaces()[plane];
    if (!Tessellation<2>::neighbour(half_space)) continue;
    half_space.offset -= tessellation.half_film(site, half_space, thickness);
    if (result.cell.cut(half_space)) result.origin.push_back(plane);
  }
  return result;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

std::size_t GrainPolygon::corner_before(std::size_t edge) const {
  for (std::size_t step = 0; step < edges.size(); ++step) {
    if (const auto& face = edges[(edge + step) % edges.size()].face) return *face;
  }
  return nowhere;
}

std::size_t GrainPolygon::corner_after(std::size_t edge) const {
  return corner_before((edge + 1) % edges.size());
}

GrainPolygon grain_polygon(const Tessellation<2>& tessellation, std::size_t site, double thickness) {
  constexpr double least_share = 1e-3;
  const double side = tessellation.side();
  const auto& cell = tessellation.cell(site);
  GrainPolygon grain;
  std::vector<std::size_t> edge_of(cell.half_spaces().size(), nowhere);
  for (const auto half_space : outline(cell).half_spaces) {
    const auto& face = cell.half_spaces()[half_space];
    const auto image = Tessellation<2>::image(face);
    edge_of[half_space] = grain.edges.size();
    grain.edges.push_back({Tessellation<2>::neighbour(face), {image[0], image[1]}, to_eigen(face.normal), {}});
  }

  const auto remaining = eroded(tessellation, site, thickness * side);
  const auto found = outline(remaining.cell);
  const auto origin = to_eigen(tessellation.sites().sites[site].position);
  std::vector<Eigen::Vector2d> corners(grain.edges.size());
  std::vector<bool> is_left(grain.edges.size(), false);
  std::size_t faces = 0;
  for (std::size_t corner = 0; corner < found.corners.size(); ++corner) {
    const auto& begin = found.corners[corner];
    const auto& end = found.corners[(corner + 1) % found.corners.size()];
    const auto origin_of_face = remaining.origin[found.half_spaces[corner]];
    const auto& face = cell.half_spaces()[origin_of_face];
    const double film = Tessellation<2>::neighbour(face) ? 2.0 * tessellation.half_film(site, face, thickness * side)
                                                         : thickness * side;
    if ((end - begin).norm() < least_share * film) continue;
    const auto edge = edge_of[origin_of_face];
    corners[edge] = (origin + begin) / side;
    is_left[edge] = true;
    ++faces;
  }
  if (faces < 3) return grain;
  for (std::size_t edge = 0; edge < corners.size(); ++edge) {
    if (!is_left[edge]) continue;
    grain.edges[edge].face = grain.corners.size();
    grain.corners.push_back(corners[edge]);
  }
  return grain;
}

double area(const std::vector<Eigen::Vector2d>& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += 0.5 * cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  }
  return sum;
}

Eigen::Vector2d centroid(const std::vector<Eigen::Vector2d>& polygon) {
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
    moment += cross(a, b) / 6.0 * (a + b);
  }
  return polygon[0] + moment / area(polygon);
}

}  // namespace breccia::films

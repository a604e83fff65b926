#include "results/film_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace breccia {
namespace {

using Edge = std::pair<std::size_t, std::size_t>;

/// The edges of a tetrahedron (four corners) or a wedge (six).
std::span<const Edge> edges_of(std::size_t corners) {
  static constexpr std::array<Edge, 6> of_tetrahedron = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  static constexpr std::array<Edge, 9> of_wedge = {
      {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};
  if (corners == 4) return of_tetrahedron;
  return of_wedge;
}

/// Puts the corners of a convex polygon in the order in which they follow each other around it.
void sort_around(std::vector<std::array<double, 2>>& corners) {
  std::array<double, 2> middle{};
  for (const auto& corner : corners) {
    for (std::size_t i = 0; i < 2; ++i) middle[i] += corner[i] / static_cast<double>(corners.size());
  }
  std::ranges::sort(corners, {}, [&](const auto& at) { return std::atan2(at[1] - middle[1], at[0] - middle[0]); });
}

/// The corners of the polygon in which a plane of constant z cuts a cell; none where it does not.
std::vector<std::array<double, 2>> cut(std::span<const Vector<3>> corners, double height) {
  std::vector<std::array<double, 2>> met;
  for (const auto& [a, b] : edges_of(corners.size())) {
    const auto &from = corners[a], &to = corners[b];
    if ((from[2] < height) == (to[2] < height)) continue;
    const double share = (height - from[2]) / (to[2] - from[2]);
    met.push_back({std::lerp(from[0], to[0], share), std::lerp(from[1], to[1], share)});
  }
  sort_around(met);
  return met;
}

}  // namespace

std::vector<CellPolygon> polygons_of(const FilmFields<2>& fields, double /*side*/) {
  std::vector<CellPolygon> polygons;
  auto corner = fields.corners.begin();
  for (std::size_t i = 0; i < fields.cells.size(); ++i) {
    auto& polygon = polygons.emplace_back(CellPolygon{i, {}});
    for (std::size_t k = 0; k < fields.cells[i].corners; ++k, ++corner) {
      polygon.corners.push_back(fields.points[*corner]);
    }
  }
  return polygons;
}

std::vector<CellPolygon> polygons_of(const FilmFields<3>& fields, double side) {
  std::vector<CellPolygon> polygons;
  auto corner = fields.corners.begin();
  for (std::size_t i = 0; i < fields.cells.size(); ++i) {
    std::vector<Vector<3>> corners;
    for (std::size_t k = 0; k < fields.cells[i].corners; ++k, ++corner) corners.push_back(fields.points[*corner]);
    const auto [lowest, highest] = std::ranges::minmax(corners, {}, [](const auto& at) { return at[2]; });
    const double middle = 0.5 * side;
    for (double image = std::ceil((lowest[2] - middle) / side); middle + image * side < highest[2]; image += 1.0) {
      auto met = cut(corners, middle + image * side);
      if (met.size() >= 3) polygons.push_back({i, std::move(met)});
    }
  }
  return polygons;
}

}  // namespace breccia

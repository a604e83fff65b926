#include "discretisation/gaps/space/facet_corners.hpp"

#include <algorithm>

#include "discretisation/gaps/space/face_parts.hpp"

namespace breccia::gaps {
namespace {

constexpr std::size_t faces_of_cube = 6;

/// The edges of a cell that are on a face, in the order of ChangesOfOwner.
std::array<std::size_t, 4> edges_of_face(std::size_t face) noexcept {
  std::array<std::size_t, 4> edges{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t node = 0; node < 4; ++node) {
      edges[edge_from(node, axis)] = edge_of_cell(node_of_face(face, node), axis_of_face(face, axis));
    }
  }
  return edges;
}

/// The place of a change of owner.
Vector<3> place_of(const ChangesInCell& changes, std::size_t edge) noexcept {
  const std::size_t axis = edge / 4, others = edge % 4;
  Vector<3> place{};
  for (std::size_t other = 0; other < 2; ++other) {
    place[other < axis ? other : other + 1] = static_cast<double>((others >> other) & 1U);
  }
  place[axis] = *changes[edge];
  return place;
}

/// A line of the polygon on a face, between two edges of the cell.
struct Side {
  std::size_t face;
  std::array<std::size_t, 2> edges;

  [[nodiscard]] bool has(std::size_t edge) const noexcept { return edges[0] == edge || edges[1] == edge; }
  [[nodiscard]] std::size_t other(std::size_t edge) const noexcept { return edges[0] == edge ? edges[1] : edges[0]; }
};

/// The lines on all faces; nothing if a face has more than one.
std::optional<std::vector<Side>> sides_on_faces(const ChangesInCell& changes) {
  std::vector<Side> sides;
  for (std::size_t face = 0; face < faces_of_cube; ++face) {
    std::vector<std::size_t> changed;
    for (const auto edge : edges_of_face(face)) {
      if (changes[edge]) changed.push_back(edge);
    }
    if (changed.empty()) continue;
    if (changed.size() != 2) return std::nullopt;
    sides.push_back({face, {changed[0], changed[1]}});
  }
  return sides;
}

}  // namespace

std::optional<FacetCorners> corners_of_facet(const ChangesInCell& changes) {
  auto sides = sides_on_faces(changes);
  if (!sides || sides->empty()) return std::nullopt;
  FacetCorners facet;
  // Each line goes on where the one before ends, on another face with the same edge of the cell.
  const std::size_t first = sides->front().edges[0];
  std::size_t edge = first;
  while (true) {
    const auto next = std::ranges::find_if(*sides, [&](const Side& side) { return side.has(edge); });
    if (next == sides->end()) break;
    facet.corners.push_back(place_of(changes, edge));
    facet.faces.push_back(next->face);
    edge = next->other(edge);
    sides->erase(next);
  }
  const bool is_one_polygon = sides->empty() && edge == first;
  if (!is_one_polygon) return std::nullopt;
  return facet;
}

}  // namespace breccia::gaps

#include "results/meshes/closed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/vector_algebra.hpp"

namespace breccia {
namespace {

using Triangle = std::array<std::size_t, 3>;

Vector<3> vector_product(const Vector<3>& a, const Vector<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// An icosahedron, whose corners have the distance 1 from the origin.
ClosedSurface icosahedron() {
  constexpr double golden = std::numbers::phi;
  ClosedSurface made{{{-1.0, golden, 0.0},
                      {1.0, golden, 0.0},
                      {-1.0, -golden, 0.0},
                      {1.0, -golden, 0.0},
                      {0.0, -1.0, golden},
                      {0.0, 1.0, golden},
                      {0.0, -1.0, -golden},
                      {0.0, 1.0, -golden},
                      {golden, 0.0, -1.0},
                      {golden, 0.0, 1.0},
                      {-golden, 0.0, -1.0},
                      {-golden, 0.0, 1.0}},
                     {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (auto& corner : made.corners) corner = corner / norm(corner);
  return made;
}

/// Divides the triangles of an icosahedron, and moves the corners onto a ball of diameter 1.
class IcosahedronDivider {
 public:
  explicit IcosahedronDivider(int divisions) : divisions_(divisions) {
    for (const auto& triangle : whole_.triangles) divide(triangle);
  }

  [[nodiscard]] ClosedSurface take() { return std::move(surface_); }

 private:
  /// The corners of the icosahedron with their shares of a point, those without a share left out.
  using Key = std::vector<std::pair<std::size_t, int>>;

  void divide(const Triangle& triangle) {
    const auto at = [&](int i, int j) {
      return number({{triangle[0], divisions_ - i - j}, {triangle[1], i}, {triangle[2], j}});
    };
    for (int i = 0; i < divisions_; ++i) {
      for (int j = 0; i + j < divisions_; ++j) {
        surface_.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < divisions_) surface_.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }

  std::size_t number(Key key) {
    std::erase_if(key, [](const auto& one) { return one.second == 0; });
    std::ranges::sort(key);
    const auto [found, is_new] = numbers_.try_emplace(key, surface_.corners.size());
    if (is_new) {
      Vector<3> point{};
      for (const auto& [corner, share] : key) point += static_cast<double>(share) * whole_.corners[corner];
      surface_.corners.push_back(point / (2.0 * norm(point)));
    }
    return found->second;
  }

  ClosedSurface whole_ = icosahedron();
  int divisions_;
  std::map<Key, std::size_t> numbers_;
  ClosedSurface surface_;
};

double longest_edge_of(const ClosedSurface& surface) {
  double longest = 0.0;
  for (const auto& triangle : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, norm(surface.corners[triangle[(k + 1) % 3]] - surface.corners[triangle[k]]));
    }
  }
  return longest;
}

/// The corners of a face of a polyhedron, counter-clockwise from outside.
std::vector<std::size_t> corners_of_face(const ConvexCell<3>& polyhedron, std::size_t face, std::size_t first) {
  const auto corners = polyhedron.corners();
  // The number among the planes of a corner of one that is neither of these two.
  const auto slot_besides = [&](std::size_t corner, std::size_t one, std::size_t other) {
    std::size_t slot = 0;
    while (corners[corner].planes[slot] == one || corners[corner].planes[slot] == other) ++slot;
    return slot;
  };
  std::vector<std::size_t> found;
  std::size_t at = first;
  // The edge to the next corner is that of the face and of this plane.
  std::size_t along = corners[at].planes[slot_besides(at, face, face)];
  do {
    found.push_back(at);
    at = polyhedron.corner_across(at, slot_besides(at, face, along));
    along = corners[at].planes[slot_besides(at, face, along)];
  } while (at != first);
  Vector<3> twice_area{};
  for (std::size_t k = 1; k + 1 < found.size(); ++k) {
    twice_area += vector_product(corners[found[k]].position - corners[first].position,
                                 corners[found[k + 1]].position - corners[first].position);
  }
  if (dot(twice_area, polyhedron.half_spaces()[face].normal) < 0.0) std::ranges::reverse(found);
  return found;
}

}  // namespace

double enclosed_volume(const ClosedSurface& surface) {
  if (surface.corners.empty()) return 0.0;
  const auto& origin = surface.corners.front();
  double sixfold = 0.0;
  for (const auto& [a, b, c] : surface.triangles) {
    sixfold +=
        dot(surface.corners[a] - origin, vector_product(surface.corners[b] - origin, surface.corners[c] - origin));
  }
  return sixfold / 6.0;
}

ClosedSurface divided_icosahedron(double longest_edge) {
  if (!(longest_edge >= shortest_longest_edge && longest_edge <= 1.0)) {
    throw InputError(fmt::format("the longest edge of a surface must be from {} to 1 of the diameter, got {}",
                                 shortest_longest_edge, longest_edge));
  }
  constexpr double edge_of_icosahedron = 0.5257;  // of its diameter, rounded down
  auto divisions = std::max(1, static_cast<int>(edge_of_icosahedron / longest_edge));
  auto surface = IcosahedronDivider(divisions).take();
  while (longest_edge_of(surface) > longest_edge) surface = IcosahedronDivider(++divisions).take();
  return surface;
}

ClosedSurface surface_of(const Ellipsoid& ellipsoid, const ClosedSurface& unit_ball) {
  ClosedSurface surface = unit_ball;
  for (auto& corner : surface.corners) {
    auto place = ellipsoid.centre;
    for (std::size_t k = 0; k < corner.size(); ++k) place += corner[k] * ellipsoid.axes[k] * ellipsoid.directions[k];
    corner = place;
  }
  return surface;
}

ClosedSurface surface_of(const ConvexCell<3>& polyhedron, const Vector<3>& place) {
  ClosedSurface surface;
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> corner_of_face(polyhedron.half_spaces().size(), none);
  for (const auto& corner : polyhedron.corners()) {
    for (const auto plane : corner.planes) corner_of_face[plane] = surface.corners.size();
    surface.corners.push_back(place + corner.position);
  }
  for (std::size_t face = 0; face < corner_of_face.size(); ++face) {
    if (corner_of_face[face] == none) continue;
    const auto around = corners_of_face(polyhedron, face, corner_of_face[face]);
    for (std::size_t k = 1; k + 1 < around.size(); ++k) {
      surface.triangles.push_back({around[0], around[k], around[k + 1]});
    }
  }
  return surface;
}

}  // namespace breccia

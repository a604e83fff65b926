#include "films/mesh/grain_mesh.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "films/mesh/grading.hpp"

namespace breccia::films {
namespace {

using Triangle = std::array<std::size_t, 3>;

using Ring = std::vector<std::size_t>;  // indices of vertices, counter-clockwise

/// Adds the triangles between a ring and the next ring inside, whose vertices are behind every second vertex of the
/// outer one.
void fill_between(const Ring& outer, const Ring& inner, std::vector<Triangle>& triangles) {
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const std::size_t here = inner[i], next = inner[(i + 1) % inner.size()];
    const std::size_t first = outer[2 * i], second = outer[(2 * i + 1) % outer.size()];
    triangles.push_back({here, first, second});
    triangles.push_back({here, second, next});
    if (2 * i + 1 < outer.size()) triangles.push_back({next, second, outer[(2 * i + 2) % outer.size()]});
  }
}

double perimeter(const std::vector<Eigen::Vector2d>& polygon) {
  double length = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) length += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
  return length;
}

/// Triangles of three corners that fill a polygon. The vertices inside are added to those of the polygon.
std::vector<Triangle> fill(std::vector<Eigen::Vector2d>& vertices) {
  constexpr double least_scale = 0.35;
  constexpr std::size_t fewest = 6;
  const Eigen::Vector2d centre = centroid(vertices);
  const double radius = std::sqrt(area(vertices) / std::numbers::pi), length = perimeter(vertices);
  Ring ring(vertices.size());
  std::iota(ring.begin(), ring.end(), std::size_t{0});
  std::vector<Triangle> triangles;
  double scale = 1.0;  // scale of the ring relative to the boundary
  while (ring.size() >= 2 * fewest) {
    const double inner_scale = scale * (1.0 - length / (static_cast<double>(ring.size()) * radius));
    if (inner_scale < least_scale) break;
    Ring inner;
    for (std::size_t i = 0; i < ring.size(); i += 2) {
      inner.push_back(vertices.size());
      vertices.emplace_back(centre + inner_scale / scale * (vertices[ring[i]] - centre));
    }
    fill_between(ring, inner, triangles);
    ring = std::move(inner);
    scale = inner_scale;
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    triangles.push_back({ring[i], ring[(i + 1) % ring.size()], vertices.size()});
  }
  vertices.push_back(centre);
  return triangles;
}

}  // namespace

GrainMesh grain_mesh(const GrainPolygon& grain, std::span<const int> segments) {
  std::vector<std::vector<double>> divisions;
  for (const int of_face : segments) {
    auto& shares = divisions.emplace_back();
    for (int k = 0; k < of_face; ++k) shares.push_back(graded(1.0 * k / of_face));
  }
  return grain_mesh(grain, divisions);
}

GrainMesh grain_mesh(const GrainPolygon& grain, std::span<const std::vector<double>> divisions) {
  std::vector<Eigen::Vector2d> vertices;
  for (std::size_t c = 0; c < grain.corners.size(); ++c) {
    const auto &begin = grain.corners[c], &end = grain.corners[grain.next_corner(c)];
    for (const double share : divisions[c]) vertices.emplace_back(begin + share * (end - begin));
  }
  const std::size_t on_boundary = vertices.size();
  const auto triangles = fill(vertices);

  GrainMesh mesh;
  mesh.boundary_nodes = 2 * on_boundary;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
  std::vector<std::size_t> number(vertices.size());
  const auto middle = [&](std::size_t a, std::size_t b) {
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), mesh.nodes.size());
    if (is_new) mesh.nodes.emplace_back(0.5 * (vertices[a] + vertices[b]));
    return found->second;
  };
  for (std::size_t v = 0; v < on_boundary; ++v) {
    number[v] = mesh.nodes.size();
    mesh.nodes.push_back(vertices[v]);
    middle(v, (v + 1) % on_boundary);
  }
  for (std::size_t v = on_boundary; v < vertices.size(); ++v) {
    number[v] = mesh.nodes.size();
    mesh.nodes.push_back(vertices[v]);
  }
  for (const auto& [a, b, c] : triangles) {
    mesh.triangles.push_back({number[a], number[b], number[c], middle(a, b), middle(b, c), middle(c, a)});
  }
  return mesh;
}

}  // namespace breccia::films

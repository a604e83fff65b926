#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "films/mesh/grain_polygon.hpp"

namespace breccia::films {

/// A grain as triangles with straight edges and six nodes each. The nodes of the boundary come first, counter-clockwise
/// from the first corner: each element of a face has its beginning and its middle.
struct GrainMesh {
  std::vector<Eigen::Vector2d> nodes;
  std::size_t boundary_nodes = 0;
  /// Three corners counter-clockwise, then the middles of the edges from the first, the second and the third corner.
  std::vector<std::array<std::size_t, 6>> triangles;
};

/// The mesh of a grain with `segments` equal elements along each face. It has rings of triangles around the centroid,
/// each with half as many elements as the next ring outside, as long as the elements are smaller than the distance from
/// the centroid; then a fan.
[[nodiscard]] GrainMesh grain_mesh(const GrainPolygon& grain, std::span<const int> segments);

/// The mesh of a grain with elements of any length: `divisions` are, for each face, the shares of its length at which
/// elements start; the first one starts at 0.
[[nodiscard]] GrainMesh grain_mesh(const GrainPolygon& grain, std::span<const std::vector<double>> divisions);

}  // namespace breccia::films

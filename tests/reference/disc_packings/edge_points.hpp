#pragma once

#include <vector>

#include <Eigen/Core>

#include "packing.hpp"

namespace disc_packings {

struct MeshSize {
  int order;      ///< order of the displacements
  double length;  ///< length of an element along an edge, as a share of sqrt(R h): see edge_points
  int layers;     ///< layers of elements from a disc to the edge of its cell
};

/// An edge between two cells.
struct Edge {
  Eigen::Vector2d begin, end;
  Disc one, other;         ///< the discs on both sides
  std::vector<Disc> near;  ///< all neighbours of both discs, and thus both, too
};

/// The nodes on an edge. An element at a point is as long as a share of the least sqrt(R h) over the pairs of one of
/// the two discs with one that is near: R is the radius of their neck, h the sum of the distances from the point to
/// their surfaces. So the pressure in a neck, which varies over sqrt(R gap), is resolved for any gap.
[[nodiscard]] std::vector<Eigen::Vector2d> edge_points(const Edge& edge, const MeshSize& size);

}  // namespace disc_packings

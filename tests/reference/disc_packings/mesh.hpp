#pragma once

#include <vector>

#include <Eigen/Core>

#include "edge_points.hpp"
#include "laguerre_cells.hpp"
#include "packing.hpp"

namespace disc_packings {

enum class Filler { rigid, deformable };
enum class Region { binder, disc };

/// A quadrilateral with (order + 1) x (order + 1) nodes, row by row from the disc outwards.
struct MeshElement {
  Region region;
  int disc;  ///< the disc in whose cell it is
  std::vector<int> nodes;
  std::vector<Eigen::Vector2d> points;  ///< where the nodes are, not wrapped into the box
};

struct Mesh {
  std::vector<MeshElement> elements;
  std::vector<int> disc_of_arc;  ///< for each node the disc on whose circle it is; -1 elsewhere
  std::vector<bool> is_on_wall;  ///< for each node
};

/// Elements between the discs and the edges of their cells and, if the discs are deformable, within the discs.
[[nodiscard]] Mesh make_mesh(const Packing& packing, Box box, Filler filler, const MeshSize& size);

}  // namespace disc_packings

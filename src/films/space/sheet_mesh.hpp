#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "films/space/cell_complex.hpp"

namespace breccia::films {

/// A node of the sheets, displaced by whole sides of the box.
struct SheetNode {
  std::size_t number;
  Eigen::Vector3i image;  ///< sides of the box
};

/// A triangle of a face: its corners counter-clockwise as the second cell sees them, then the middles of the edges from
/// the first, the second and the third corner. They are beside the first cell.
struct SheetTriangle {
  std::size_t face = 0;
  std::array<SheetNode, 6> nodes;
  bool is_at_rim = false;  ///< whether the edge from its second to its third corner is part of an edge of the face
};

/// An element of an edge of the cells: its start, middle and end.
struct SheetSegment {
  std::size_t edge = 0;
  std::array<SheetNode, 3> nodes;
};

/// The faces and edges of a complex of cells as elements with straight edges, which meet along whole edges. Both sides
/// of a film and its pressures have these nodes. Lengths are in sides of the box.
struct SheetMesh {
  int divisions = 1;  ///< number of elements along each edge
  std::vector<Eigen::Vector3d> nodes;
  std::vector<SheetTriangle> triangles;
  std::vector<SheetSegment> segments;
  std::vector<SheetNode> points;  ///< the nodes of CellComplex::points

  [[nodiscard]] Eigen::Vector3d position(const SheetNode& node) const {
    return nodes[node.number] + node.image.cast<double>();
  }
};

/// The mesh with a number of elements along each edge. A face is a fan of triangles around the mean of its corners,
/// each of which is cut into divisions^2.
[[nodiscard]] SheetMesh sheet_mesh(const CellComplex& complex, int divisions);

}  // namespace breccia::films

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "breccia/microstructure/tessellation.hpp"

namespace breccia::films {

/// A cell of a periodic tessellation, displaced by whole sides of the box.
struct CellImage {
  std::size_t cell;
  Eigen::Vector3i image;  ///< sides of the box
};

/// A vertex of the cells, displaced by whole sides of the box.
struct VertexImage {
  std::size_t vertex;
  Eigen::Vector3i image;  ///< sides of the box
};

/// The face between two cells.
struct SharedFace {
  std::size_t first;  ///< the cell before it
  CellImage second;   ///< the cell beyond it
  /// Its corners beside the first cell, counter-clockwise as the second cell sees them.
  std::vector<VertexImage> corners;
};

/// The edge along which three cells meet.
struct SharedEdge {
  std::array<CellImage, 3> cells;  ///< counter-clockwise, as its end sees them
  std::array<VertexImage, 2> ends;
};

/// A point at which four cells meet. The tetrahedron of their sites has a positive volume.
struct SharedPoint {
  std::array<CellImage, 4> cells;
  VertexImage vertex;
};

/// The faces, edges and vertices of the cells of a periodic tessellation, each once. Lengths are in sides of the box.
/// Vertices that are closer to each other than 1e-4 of a mean cell are one vertex, with several points of four cells.
struct CellComplex {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<SharedFace> faces;
  std::vector<SharedEdge> edges;
  std::vector<SharedPoint> points;

  [[nodiscard]] Eigen::Vector3d position(const VertexImage& at) const {
    return vertices[at.vertex] + at.image.cast<double>();
  }
};

/// The complex of a periodic tessellation. Positions and weights of its sites are changed by 1e-7 of a mean cell, so
/// that no more than four cells meet at a point. Throws InputError when cells do not agree on their vertices, as
/// where a cell touches images of itself on several sides.
[[nodiscard]] CellComplex cell_complex(const Tessellation<3>& tessellation);

}  // namespace breccia::films

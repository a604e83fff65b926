#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "breccia/microstructure/tessellation.hpp"

namespace breccia::films {

/// An edge of a cell of a tessellation, and its neighbour.
struct CellEdge {
  std::optional<std::size_t> neighbour;             ///< the site beyond the edge; none beyond a wall
  Eigen::Vector2i image = Eigen::Vector2i::Zero();  ///< sides of the box by which that site is displaced
  Eigen::Vector2d normal;                           ///< outward normal of length 1
  std::optional<std::size_t> face;  ///< the face of the grain that belongs to this edge, unless it has vanished
};

/// A grain: a cell of a tessellation without its share of the films. Walls cut cells and films like a window in a
/// larger body, so that no film runs along them. Lengths are in units of the side of the box, positions are relative to
/// its origin. A periodic grain may reach beyond the sides.
struct GrainPolygon {
  std::vector<Eigen::Vector2d> corners;  ///< counter-clockwise; the face of the same number begins there
  std::vector<CellEdge> edges;  ///< edges of the cell, counter-clockwise; the faces of the grain are in this order

  /// The corner of the grain at the end of an edge of the cell, or that in which the edge has vanished.
  [[nodiscard]] std::size_t corner_after(std::size_t edge) const;
  /// The corner at the beginning of an edge.
  [[nodiscard]] std::size_t corner_before(std::size_t edge) const;
  [[nodiscard]] std::size_t next_corner(std::size_t corner) const noexcept { return (corner + 1) % corners.size(); }
};

/// The grain of a site, between films of this thickness [sides]. A face shorter than a thousandth of the thickness
/// counts as vanished. The grain has no corners if fewer than three faces are left.
[[nodiscard]] GrainPolygon grain_polygon(const Tessellation<2>& tessellation, std::size_t site, double thickness);

[[nodiscard]] double area(const std::vector<Eigen::Vector2d>& polygon);
[[nodiscard]] Eigen::Vector2d centroid(const std::vector<Eigen::Vector2d>& polygon);

}  // namespace breccia::films

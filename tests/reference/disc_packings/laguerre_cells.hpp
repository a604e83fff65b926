#pragma once

#include <vector>

#include <Eigen/Core>

#include "packing.hpp"

namespace disc_packings {

/// A disc of the packing or an image of it: shifted by so many boxes or, in a box with walls, the mirror image in the
/// wall between the box and this neighbour of it.
struct Image {
  int disc;
  int boxes_x, boxes_y;
  bool is_mirrored = false;

  [[nodiscard]] Eigen::Vector2d move(const Eigen::Vector2d& point) const;
  [[nodiscard]] Disc move(const Disc& moved) const { return {move(moved.centre), moved.radius}; }
  [[nodiscard]] Disc of(const Packing& packing) const { return move(packing[disc]); }
};

/// The cell of a disc: side s is the edge from corner s to the next one, counter-clockwise.
struct LaguerreCell {
  std::vector<Eigen::Vector2d> corners;
  std::vector<Image> beyond;  ///< the disc beyond each side
  std::vector<int> vertices;  ///< the vertex at each corner; corners of all cells that are images share their vertex

  [[nodiscard]] int sides() const { return static_cast<int>(corners.size()); }
  [[nodiscard]] const Eigen::Vector2d& end_of_side(int side) const;

  /// Are both ends of a side the same vertex?
  [[nodiscard]] bool is_collapsed(int side) const;

  /// The first corner that is where this one is: this one itself, unless edges are collapsed.
  [[nodiscard]] int first_corner_at(int corner) const;
};

/// The Laguerre (power) cells of the discs, with the radii as weights: as long as no discs overlap, each contains its
/// disc, and every edge runs between the surfaces of two discs. Edges much shorter than their distance from the disc
/// are collapsed to a vertex. A wall is the edge between a disc and its mirror image.
[[nodiscard]] std::vector<LaguerreCell> laguerre_cells(const Packing& packing, Box box);

}  // namespace disc_packings

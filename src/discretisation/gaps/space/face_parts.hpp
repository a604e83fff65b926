#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "breccia/microstructure/vector.hpp"

namespace breccia::gaps {

// Places and lengths are in units of the cell side.

/// Where the owner changes along the edges of a face of a cubic cell, from the lower node of the edge, 0, to the upper
/// one, 1; nothing on an edge whose nodes have the same owner. The edges along the first axis of the face come first,
/// lower and upper, then those along the second axis, left and right. Nodes are in the order of CellShape<2>.
using ChangesOfOwner = std::array<std::optional<double>, 4>;

/// The number of the edge of a face that goes from a node along an axis.
[[nodiscard]] constexpr std::size_t edge_from(std::size_t node, std::size_t axis) noexcept {
  return 2 * axis + ((node >> (1 - axis)) & 1U);
}

/// The flux of a displacement through a face whose nodes have owners, as a form of the displacements of its nodes along
/// its normal, and of the slopes of these displacements in the particles of the nodes, by axis of the face.
struct FaceFlux {
  std::array<double, 4> of_nodes = {};
  std::array<Vector<2>, 4> of_slopes = {};  ///< zero along edges on which the owner does not change
};

/// Each node has the part of the face up to the changes of owner, or the middles, of its two edges and up to their
/// centre, the mean of the changes; the displacement is linear there (docs/gaps-in-space.md). Linear displacements have
/// their flux exactly, and so have particles that move and turn.
[[nodiscard]] FaceFlux flux_through_face(const ChangesOfOwner& changes);

}  // namespace breccia::gaps

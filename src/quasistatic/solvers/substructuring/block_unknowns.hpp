#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "breccia/microstructure/index.hpp"

namespace breccia::quasistatic {

struct Block;

/// The numbers [begin, end) of the unknowns of the face that begins at a node and goes along an axis (GapCell); a node
/// behind the end of a periodic box is that at its beginning. An empty function is that of cells without gaps.
using UnknownsOfFaces = std::function<std::array<std::int32_t, 2>(const Index<2>& node, std::size_t axis)>;

/// An unknown of a block: a displacement component of a node, or an unknown of a face.
struct BlockUnknown {
  static constexpr std::int32_t none = -1;
  int x = 0, y = 0;             ///< place of the node in its block, in cells from the lower left corner
  int component = 0;            ///< component of the displacement of the node
  std::int32_t of_face = none;  ///< number of the unknown of a face
};

/// The unknowns inside a block: row by row those of each node and of the faces that begin at it.
[[nodiscard]] std::vector<BlockUnknown> inside_unknowns(const Block& block, const UnknownsOfFaces& faces);
/// The unknowns of the boundary of a block: those of the nodes of each side without the vertices and then those of its
/// faces, in the order of boundary_nodes; at last those of the vertices.
[[nodiscard]] std::vector<BlockUnknown> boundary_unknowns(const Block& block, const UnknownsOfFaces& faces);

}  // namespace breccia::quasistatic

#pragma once

#include <vector>

#include "boundary.hpp"
#include "mesh.hpp"
#include "packing.hpp"

namespace disc_packings {

/// The unknowns of a mesh are the fluctuations of the displacement: x and y of every node, but of a rigid disc x, y and
/// the turn (times the radius) in place of the nodes on its circle. The first ones are held at zero: all on walls with
/// given displacements; elsewhere as many as take away the rigid motions of the box, which have no energy. If tractions
/// are given, the fluctuations are the displacements themselves.
struct Unknowns {
  int count, held;
  int first_of_first_disc;
  std::vector<int> first_of_node;  ///< -1: the node follows its rigid disc

  [[nodiscard]] int first_of_disc(int disc) const { return first_of_first_disc + 3 * disc; }
};
[[nodiscard]] Unknowns number_unknowns(const Mesh& mesh, const Packing& packing, Filler filler, Boundary boundary);

}  // namespace disc_packings

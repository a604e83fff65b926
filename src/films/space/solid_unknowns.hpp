#pragma once

#include <span>

#include <Eigen/Core>

#include "films/assembly/matrix_assembly.hpp"

namespace breccia::films {

/// A node of an element in space.
struct ElementNode {
  int number = 0;            ///< number in the mesh, from 0
  Eigen::Vector3d position;  ///< position in the image of the box in which the element is
};

/// The unknowns of an element: three displacement components of each node, of which those of the first node of the mesh
/// are held, and then others. The macroscopic motion is relative to the first node of the element: a translation does
/// no work on it.
[[nodiscard]] ElementUnknowns<3> solid_unknowns(std::span<const ElementNode> nodes, std::span<const int> others = {});

/// Number of the displacements of this number of nodes.
[[nodiscard]] constexpr int displacements_of(int nodes) noexcept {
  return 3 * (nodes - 1);
}

}  // namespace breccia::films

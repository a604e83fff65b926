#pragma once

#include <cstddef>
#include <vector>

#include "films/mesh/conforming_mesh.hpp"

namespace breccia::films {

/// A node of a periodic box, displaced by whole sides.
template <int dim>
struct NodeImage {
  std::size_t number = 0;  ///< number that a node and all its images share
  Index<dim> image = {};   ///< sides of the box
};

/// Finds the surfaces of a mesh whose nodes are these images, and the pairs of surfaces that are opposite.
template <int dim>
void find_surfaces(ConformingMesh<dim>& mesh, const std::vector<NodeImage<dim>>& images);

}  // namespace breccia::films

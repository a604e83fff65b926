#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "films/space/solid_elements.hpp"
#include "films/space/space_mesh.hpp"

namespace breccia::films {

/// A tetrahedron with straight edges and ten nodes: four corners, of a positive volume, then the middles of the edges
/// (edges_of_tetrahedron). Positions are in the image of the box in which the element is.
struct QuadraticTetrahedron {
  std::array<std::size_t, 10> nodes{};
  TetrahedronCorners corners;  ///< positions of the corners
};

/// A periodic box of grains and binder in space as conforming tetrahedra. Lengths are in sides of the box.
struct ResolvedSolids {
  std::vector<Eigen::Vector3d> nodes;
  std::vector<QuadraticTetrahedron> grains, binder;
  std::vector<std::size_t> grain_of_element;  ///< number of the grain of each element of `grains`
};

/// The mesh of grains whose films, channels and junctions are cut into a number of layers across every film. Layers are
/// thinner at the faces (theory, section 17).
[[nodiscard]] ResolvedSolids resolved_solids(const SpaceMesh& mesh, int layers);

}  // namespace breccia::films

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "breccia/films/film_problem.hpp"

namespace breccia::films {

/// An element with straight edges: its corners counter-clockwise, then the middles of the edges that start at them and,
/// for a quadrilateral, its centre. Positions are in the image of the box in which the element is.
template <std::size_t corners, std::size_t count>
struct MeshElement {
  std::array<std::size_t, count> nodes;
  std::array<Eigen::Vector2d, corners> positions;  ///< positions of the corners
};
using MeshTriangle = MeshElement<3, 6>;
using MeshQuadrilateral = MeshElement<4, 9>;

/// A box of grains and binder as conforming elements, several of them across each film. Lengths are in sides.
struct ResolvedMesh {
  std::vector<Eigen::Vector2d> nodes;  ///< positions of the nodes of elements with quadratic displacements
  std::vector<MeshTriangle> grains;
  std::vector<std::size_t> grain_of_element;  ///< number of the grain of each element of `grains`
  /// The elements of the binder: the films, and the junctions around their centres.
  std::vector<MeshQuadrilateral> quadrilaterals;
  std::vector<MeshTriangle> triangles;
};

/// The mesh of a problem with layers. Across a film elements are thinner at its faces, and along it shorter at its
/// ends, where corners of grains concentrate the shear (theory, section 17). Throws InputError when a grain vanishes in
/// its films or a junction has a shape that cannot be meshed.
[[nodiscard]] ResolvedMesh resolved_mesh(const FilmProblem<2>& problem);

}  // namespace breccia::films

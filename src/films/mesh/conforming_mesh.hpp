#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "breccia/films/film_problem.hpp"
#include "breccia/microstructure/index.hpp"
#include "breccia/microstructure/vector.hpp"

namespace breccia::films {

/// A triangle or tetrahedron with straight edges. Its corners are counter-clockwise; in space the first three are so,
/// seen from the fourth.
template <int dim>
struct Simplex {
  std::array<std::size_t, std::size_t{dim} + 1> nodes{};
  std::optional<std::size_t> grain = {};  ///< number of its grain, that of the site; nothing in the binder
};

/// What lies beyond a part of the surface of a mesh.
enum class Beyond {
  image,  ///< an image of the mesh itself, displaced by whole sides of the box
  wall,   ///< a wall of the box
  gap     ///< a film that is debonded
};

/// A part of the surface of a mesh: edges of triangles with the mesh on their left, or faces of tetrahedra,
/// counter-clockwise from outside.
template <int dim>
struct MeshSurface {
  Beyond beyond = Beyond::gap;
  /// Of an image: the sides of the box by which it is displaced along each axis; of a wall: its outward direction.
  Index<dim> direction = {};
  std::vector<std::array<std::size_t, std::size_t{dim}>> facets = {};
};

/// Two parts of the surface, the second of which is the first one displaced by whole sides of the box.
template <int dim>
struct OppositeSurfaces {
  std::size_t first = 0, second = 0;                   ///< indices of the surfaces
  Index<dim> displacement = {};                        ///< sides of the box
  std::vector<std::array<std::size_t, 2>> nodes = {};  ///< the nodes of the first surface, and those displaced
};

/// Grains and binder as triangles or tetrahedra that meet at whole edges and faces. In a periodic box grains are whole
/// where they are, so that the mesh reaches beyond the sides of the box; with its images, displaced by whole sides, it
/// fills the space.
template <int dim>
struct ConformingMesh {
  double side = 0.0;  ///< side of the box [m]
  Walls walls = Walls::periodic;
  std::vector<Vector<dim>> nodes;      ///< positions [m]
  std::vector<Simplex<dim>> elements;  ///< those of the grains in the order of the grains, then those of the binder
  std::vector<MeshSurface<dim>> surfaces;
  std::vector<OppositeSurfaces<dim>> opposites;
};

/// Area [m^2] or volume [m^3] of an element; negative where it is inverted.
template <int dim>
[[nodiscard]] double content_of(const ConformingMesh<dim>& mesh, const Simplex<dim>& element);

/// The mesh of a problem with layers, as the solver has it, but for quadrilaterals, which are two triangles here.
/// Throws InputError when the problem has no layers, and as resolved_mesh() and SpaceMesh do.
template <int dim>
[[nodiscard]] ConformingMesh<dim> conforming_mesh(const FilmProblem<dim>& problem);

}  // namespace breccia::films

#pragma once

#include <string>

#include "films/mesh/conforming_mesh.hpp"

namespace breccia {

/// The names of the physical groups of a mesh.
struct MeshMaterials {
  std::string grains, binder;
};

/// The name of the physical group of a surface: "side_x_plus" beyond which the image lies that is displaced by one side
/// of the box along x, "side_x_plus_y_minus", "wall_x_minus", or "gap".
template <int dim>
[[nodiscard]] std::string name_of(const films::MeshSurface<dim>& surface);

/// A mesh in the format MSH 2.2 of Gmsh, as text, with `scale` units of length in a metre. The elements of the grains
/// and of the binder are two physical groups; those of each grain are an elementary entity whose number is that of the
/// grain, counted from 1, and those of the binder are the next one. Each surface is a group and an entity of one
/// dimension less. Opposite surfaces are periodic, with the pairs of their nodes.
template <int dim>
[[nodiscard]] std::string msh_text(const films::ConformingMesh<dim>& mesh, const MeshMaterials& materials,
                                   double scale);

}  // namespace breccia

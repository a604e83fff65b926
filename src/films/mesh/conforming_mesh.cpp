#include "films/mesh/conforming_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/LU>

#include "breccia/error.hpp"

#include "films/mesh/mesh_surfaces.hpp"
#include "films/mesh/resolved_mesh.hpp"
#include "films/space/resolved_solids.hpp"
#include "films/space/space_mesh.hpp"

namespace breccia::films {
namespace {

/// A corner of an element: the number that it shares with its images, and its position [sides of the box].
template <int dim>
struct Corner {
  std::size_t number;
  Eigen::Matrix<double, dim, 1> position;
};

/// Collects elements, whose nodes it gives a place in the image of the box in which the element is.
template <int dim>
class ElementCollector {
 public:
  using Corners = std::array<Corner<dim>, std::size_t{dim} + 1>;

  /// `positions` are those of the nodes, each in one image of the box [sides of the box].
  ElementCollector(const Tessellation<dim>& tessellation, std::vector<Eigen::Matrix<double, dim, 1>> positions)
      : positions_(std::move(positions)) {
    mesh_.side = tessellation.side();
    mesh_.walls = tessellation.walls();
  }

  /// Adds an element; one that has no extent, since corners coincide, is left out.
  void add(const Corners& corners, std::optional<std::size_t> grain) {
    Simplex<dim> element{{}, grain};
    for (std::size_t k = 0; k < corners.size(); ++k) element.nodes[k] = number(corners[k]);
    auto sorted = element.nodes;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) == sorted.end()) mesh_.elements.push_back(element);
  }

  [[nodiscard]] ConformingMesh<dim> finish() {
    find_surfaces(mesh_, images_);
    return std::move(mesh_);
  }

 private:
  std::size_t number(const Corner<dim>& corner) {
    const auto& reference = positions_[corner.number];
    NodeImage<dim> node{corner.number, {}};
    Vector<dim> place{};
    for (int axis = 0; axis < dim; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      node.image[i] = static_cast<int>(std::lround(corner.position[axis] - reference[axis]));
      place[i] = (reference[axis] + node.image[i]) * mesh_.side;
    }
    const auto [found, is_new] = numbers_.try_emplace({node.number, node.image}, images_.size());
    if (is_new) {
      images_.push_back(node);
      mesh_.nodes.push_back(place);
    }
    return found->second;
  }

  std::vector<Eigen::Matrix<double, dim, 1>> positions_;
  std::map<std::pair<std::size_t, Index<dim>>, std::size_t> numbers_;
  std::vector<NodeImage<dim>> images_;  ///< by the numbers of the nodes of the mesh
  ConformingMesh<dim> mesh_;
};

template <class Element>
Corner<2> corner_of(const Element& element, std::size_t k) {
  return {element.nodes[k], element.positions[k]};
}

/// Twice the area of the triangle between three corners of a quadrilateral.
double twice_area(const MeshQuadrilateral& element, const std::array<std::size_t, 3>& corners) {
  const Eigen::Vector2d one = element.positions[corners[1]] - element.positions[corners[0]];
  const Eigen::Vector2d other = element.positions[corners[2]] - element.positions[corners[0]];
  return one.x() * other.y() - one.y() * other.x();
}

/// The two triangles of a quadrilateral, by the diagonal that leaves the larger of the smaller triangles.
std::array<std::array<std::size_t, 3>, 2> triangles_of(const MeshQuadrilateral& element) {
  using Triangles = std::array<std::array<std::size_t, 3>, 2>;
  constexpr Triangles by_first = {{{0, 1, 2}, {0, 2, 3}}}, by_second = {{{0, 1, 3}, {1, 2, 3}}};
  const auto smaller = [&](const Triangles& triangles) {
    return std::min(twice_area(element, triangles[0]), twice_area(element, triangles[1]));
  };
  return smaller(by_first) >= smaller(by_second) ? by_first : by_second;
}

ConformingMesh<2> mesh_of(const FilmProblem<2>& problem) {
  const auto resolved = resolved_mesh(problem);
  ElementCollector<2> elements(problem.tessellation, resolved.nodes);
  const auto add = [&](const auto& element, const std::array<std::size_t, 3>& corners,
                       std::optional<std::size_t> grain) {
    elements.add({corner_of(element, corners[0]), corner_of(element, corners[1]), corner_of(element, corners[2])},
                 grain);
  };
  for (std::size_t e = 0; e < resolved.grains.size(); ++e) {
    add(resolved.grains[e], {0, 1, 2}, resolved.grain_of_element[e]);
  }
  for (const auto& element : resolved.quadrilaterals) {
    for (const auto& corners : triangles_of(element)) add(element, corners, std::nullopt);
  }
  for (const auto& element : resolved.triangles) add(element, {0, 1, 2}, std::nullopt);
  return elements.finish();
}

ConformingMesh<3> mesh_of(const FilmProblem<3>& problem) {
  const auto resolved = resolved_solids(SpaceMesh(problem), *problem.layers);
  ElementCollector<3> elements(problem.tessellation, resolved.nodes);
  const auto add = [&](const QuadraticTetrahedron& element, std::optional<std::size_t> grain) {
    ElementCollector<3>::Corners corners;
    for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = {element.nodes[k], element.corners[k]};
    elements.add(corners, grain);
  };
  for (std::size_t e = 0; e < resolved.grains.size(); ++e) add(resolved.grains[e], resolved.grain_of_element[e]);
  for (const auto& element : resolved.binder) add(element, std::nullopt);
  return elements.finish();
}

}  // namespace

template <int dim>
double content_of(const ConformingMesh<dim>& mesh, const Simplex<dim>& element) {
  Eigen::Matrix<double, dim, dim> edges;
  const auto& origin = mesh.nodes[element.nodes[0]];
  for (int k = 0; k < dim; ++k) {
    const auto& corner = mesh.nodes[element.nodes[static_cast<std::size_t>(k) + 1]];
    for (int axis = 0; axis < dim; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      edges(axis, k) = corner[i] - origin[i];
    }
  }
  return edges.determinant() / (dim == 2 ? 2.0 : 6.0);
}

template <int dim>
ConformingMesh<dim> conforming_mesh(const FilmProblem<dim>& problem) {
  require_sound(problem);
  if (!problem.layers) throw InputError("films: a mesh of the binder between grains takes a number of layers");
  return mesh_of(problem);
}

template double content_of(const ConformingMesh<2>&, const Simplex<2>&);
template double content_of(const ConformingMesh<3>&, const Simplex<3>&);
template ConformingMesh<2> conforming_mesh(const FilmProblem<2>&);
template ConformingMesh<3> conforming_mesh(const FilmProblem<3>&);

}  // namespace breccia::films

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "breccia/discretisation/boundary.hpp"

#include "films/assembly/film_matrices.hpp"
#include "films/mesh/film_network.hpp"
#include "films/mesh/grain_mesh.hpp"

namespace breccia::films {

/// Numbers of the unknowns of a network of films: the fluctuations of the displacement of the nodes of the grains, then
/// the flows at both ends of each element of each film, under a traction boundary the slip of each opening of a film
/// in a wall, and the jumps along each film on springs; the pressures have numbers of their own, those of the junctions
/// first.
///
/// A displacement boundary holds the fluctuation at zero on the walls; as many components as there are rigid motions
/// are held at zero under the other boundaries.
class Unknowns {
 public:
  /// `is_on_springs`: for each film, whether springs hold it to the grain on its second side.
  Unknowns(const FilmNetwork& network, const std::vector<GrainMesh>& meshes, Boundary boundary,
           const std::vector<bool>& is_on_springs);

  [[nodiscard]] int count() const noexcept { return count_; }
  [[nodiscard]] int pressures() const noexcept { return pressures_; }

  /// The number of a displacement component of a node of a grain, or `held`.
  [[nodiscard]] int displacement(std::size_t grain, std::size_t node, int component) const noexcept {
    return displacements_[grain][2 * node + static_cast<std::size_t>(component)];
  }
  /// The number of a node on the boundary of a grain: the node at the beginning of an element of a face, or `past`
  /// nodes after it.
  [[nodiscard]] std::size_t node(std::size_t grain, std::size_t face, int past) const noexcept {
    return (first_nodes_[grain][face] + static_cast<std::size_t>(past)) % boundary_nodes_[grain];
  }
  /// The number of the flow at the start (0) or the end (1) of an element of a film.
  [[nodiscard]] int flow(std::size_t film, int element, int end) const noexcept {
    return first_flows_[film] + 2 * element + end;
  }
  /// The number of the slip of the opening at the start (0) or the end (1) of a film, or `held` where there is none.
  [[nodiscard]] int slip(std::size_t film, std::size_t end) const noexcept { return slips_[film][end]; }
  /// The numbers of the jumps of an element of a film on springs, two components each at its start, middle and end;
  /// none of another film.
  [[nodiscard]] std::vector<int> jumps(std::size_t film, int element) const;
  /// The position of the node that a traction boundary holds against a rotation about the first node.
  [[nodiscard]] const Eigen::Vector2d& farthest_held() const noexcept { return farthest_held_; }
  /// The numbers of the pressures at the start, middle and end of an element of a film.
  [[nodiscard]] std::array<int, 3> pressures(const FilmNetwork& network, std::size_t film, int element) const noexcept;

 private:
  void hold_walls(const FilmNetwork& network);
  void hold_translations();
  void hold_rotation(const std::vector<GrainMesh>& meshes);

  std::vector<std::vector<int>> displacements_;        ///< numbers by grain and component
  std::vector<std::size_t> boundary_nodes_;            ///< number of boundary nodes, by grain
  std::vector<std::vector<std::size_t>> first_nodes_;  ///< numbers by grain and face
  std::vector<int> first_flows_, first_pressures_;     ///< numbers by film
  std::vector<std::array<int, 2>> slips_;              ///< numbers by film
  std::vector<int> first_jumps_;                       ///< numbers by film, or `held` of a film without springs
  Eigen::Vector2d farthest_held_ = Eigen::Vector2d::Zero();
  int count_ = 0, pressures_ = 0;
};

}  // namespace breccia::films

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "breccia/films/film_problem.hpp"

#include "films/assembly/debonded_set.hpp"
#include "films/assembly/interface_springs.hpp"
#include "films/assembly/matrix_assembly.hpp"
#include "films/space/cell_complex.hpp"
#include "films/space/grain_solids.hpp"
#include "films/space/sheet_mesh.hpp"
#include "films/space/shrunk_grains.hpp"
#include "films/space/wedge.hpp"

namespace breccia::films {

/// Grains, films, channels and junctions in space as elements, and the numbers of their unknowns: the fluctuations of
/// the displacements of the nodes of the grains, the flows of the triangles of the films, six each, then the jumps at
/// the nodes of the films on springs. The pressures are at the nodes of the sheets. The first node of the first grain
/// is held. Lengths are in sides of the box.
class SpaceMesh {
 public:
  explicit SpaceMesh(const FilmProblem<3>& problem);

  [[nodiscard]] const SheetMesh& sheets() const noexcept { return sheets_; }
  [[nodiscard]] const GrainSolids& grains() const noexcept { return solids_; }

  [[nodiscard]] int unknowns() const noexcept { return unknowns_; }
  /// The number of a node among those of all grains.
  [[nodiscard]] int number(const SolidNode& node) const noexcept {
    return first_node_[node.grain] + static_cast<int>(node.number);
  }
  /// The numbers of the flows of a triangle of a film.
  [[nodiscard]] std::array<int, 6> flows_of(std::size_t triangle) const;
  /// The unknowns of an element with these nodes, and with flows.
  [[nodiscard]] ElementUnknowns<3> unknowns_of(std::span<const SolidNode> nodes, std::span<const int> flows = {}) const;

  /// How the film to which a triangle belongs is debonded; nothing where it is bonded.
  [[nodiscard]] std::optional<Debonding> debonding(std::size_t triangle) const {
    return debonding_[sheets_.triangles[triangle].face];
  }
  /// The numbers of the jumps of a triangle of a film on springs, three components at each of its nodes; none of
  /// another film.
  [[nodiscard]] const std::vector<int>& jumps(std::size_t triangle) const { return jumps_[triangle]; }
  /// The springs of a triangle of a film that hold it to the grain on its second side; a bonded film has none. In units
  /// of the side of the box.
  [[nodiscard]] InterfaceSprings springs(std::size_t triangle) const;
  /// The nodes of a triangle of a film on its first side, then on its second side.
  [[nodiscard]] std::array<SolidNode, 12> nodes_of_film(std::size_t triangle) const;
  [[nodiscard]] Wedge film(std::size_t triangle) const;
  /// The nodes of an element of a channel: start, middle and end beside the first grain, then the second and the third.
  [[nodiscard]] std::array<SolidNode, 9> nodes_of_channel(std::size_t segment) const;
  /// The start and the end of an element of a channel beside each grain.
  [[nodiscard]] std::array<std::array<Eigen::Vector3d, 2>, 3> channel(std::size_t segment) const;
  /// The corners of the grains around a point of the complex.
  [[nodiscard]] std::array<SolidNode, 4> nodes_of_corner(std::size_t point) const;
  [[nodiscard]] std::array<Eigen::Vector3d, 4> corner(std::size_t point) const;

 private:
  void number_jumps();

  CellComplex complex_;
  SheetMesh sheets_;
  GrainSolids solids_;
  std::vector<int> first_node_;  ///< number of nodes before those of each grain
  int first_flow_ = 0, unknowns_ = 0;
  std::vector<std::vector<int>> jumps_;              ///< numbers of the jumps, by triangle
  std::vector<std::optional<Debonding>> debonding_;  ///< by face
  InterfaceStiffness stiffness_;                     ///< of springs [Pa]
};

}  // namespace breccia::films

#pragma once

#include <array>

#include "discretisation/gaps/gap_geometry.hpp"
#include "discretisation/gaps/plane/face_table.hpp"

namespace breccia::gaps {

/// A cell of a grid with its nodes and faces, in the orders of CellShape and of GapCell.
class CellPlace {
 public:
  CellPlace(const GapGeometry<2>& geometry, const Index<2>& cell);

  [[nodiscard]] const Index<2>& cell() const noexcept { return cell_; }
  [[nodiscard]] Vector<2> centre() const noexcept { return {cell_[0] + 0.5, cell_[1] + 0.5}; }
  /// The lower left corner.
  [[nodiscard]] Vector<2> corner() const noexcept {
    return {static_cast<double>(cell_[0]), static_cast<double>(cell_[1])};
  }
  [[nodiscard]] Index<2> node(int node) const noexcept;
  [[nodiscard]] ImageIndex owner(int node) const noexcept { return owners_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] FacePlace face_place(int face) const noexcept;
  [[nodiscard]] const Face& face(int face) const noexcept { return *faces_[static_cast<std::size_t>(face)]; }

  [[nodiscard]] static constexpr std::size_t normal(int face) noexcept { return static_cast<std::size_t>(face / 2); }
  /// The node at an end of a face.
  [[nodiscard]] static constexpr int node_of(int face, int end) noexcept {
    const int normal = face / 2, upper = face % 2;
    return (upper << normal) | (end << (1 - normal));
  }
  /// The neighbour of a node along an axis.
  [[nodiscard]] static constexpr int beside(int node, std::size_t axis) noexcept { return node ^ (1 << axis); }
  /// Whether a node is the upper one along an axis.
  [[nodiscard]] static constexpr bool is_upper(int node, std::size_t axis) noexcept {
    return ((node >> axis) & 1) != 0;
  }

  [[nodiscard]] bool has_free_node() const noexcept;
  /// Whether all nodes belong to one particle.
  [[nodiscard]] bool has_one_owner() const noexcept;
  /// Whether all nodes belong to two particles, side by side, so that the gap runs from one face to another.
  [[nodiscard]] bool is_in_chain() const noexcept;
  /// The particle of the other nodes than those of the particle of node 0.
  [[nodiscard]] ImageIndex second_owner() const noexcept;
  /// Whether a node at an end of a face belongs to walls.
  [[nodiscard]] bool is_on_wall(int face, int end) const noexcept { return owner(node_of(face, end)) == walls; }
  /// Number of the nodes that belong to a particle.
  [[nodiscard]] int nodes_of(ImageIndex image) const noexcept;

 private:
  Index<2> cell_;
  std::array<ImageIndex, 4> owners_;
  std::array<const Face*, faces_of_cell<2>> faces_;
};

}  // namespace breccia::gaps

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "discretisation/gaps/gap_geometry.hpp"
#include "discretisation/gaps/space/cube_faces.hpp"
#include "discretisation/gaps/space/facet_corners.hpp"

namespace breccia::gaps {

/// A cubic cell of a grid with its nodes and faces, in the orders of CellShape and of facet_corners.hpp.
class CubePlace {
 public:
  CubePlace(const GapGeometry<3>& geometry, const Index<3>& cell);

  [[nodiscard]] Vector<3> centre() const noexcept { return {cell_[0] + 0.5, cell_[1] + 0.5, cell_[2] + 0.5}; }
  /// The lowest corner.
  [[nodiscard]] Vector<3> corner() const noexcept {
    return {static_cast<double>(cell_[0]), static_cast<double>(cell_[1]), static_cast<double>(cell_[2])};
  }
  [[nodiscard]] Index<3> node(int node) const noexcept;
  [[nodiscard]] ImageIndex owner(int node) const noexcept { return owners_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] CubeFacePlace face_place(int face) const noexcept;
  [[nodiscard]] const CubeFace& face(int face) const noexcept { return *faces_[static_cast<std::size_t>(face)]; }

  /// The neighbour of a node along an axis.
  [[nodiscard]] static constexpr int beside(int node, std::size_t axis) noexcept { return node ^ (1 << axis); }
  /// Whether a node is the upper one along an axis.
  [[nodiscard]] static constexpr bool is_upper(int node, std::size_t axis) noexcept {
    return ((node >> axis) & 1) != 0;
  }
  /// 1 on the upper side of the cell, -1 on the lower one: the direction out of the cell.
  [[nodiscard]] static constexpr double out_of(int face) noexcept { return face % 2 != 0 ? 1.0 : -1.0; }

  /// The particles that own nodes of the cell, once each.
  [[nodiscard]] const std::vector<ImageIndex>& owners() const noexcept { return own_; }
  [[nodiscard]] bool has_free_node() const noexcept;
  /// Whether all nodes belong to particles, to two or more.
  [[nodiscard]] bool is_in_gap() const noexcept { return !has_free_node() && own_.size() > 1; }
  /// The changes of owner on the edges of the cell.
  [[nodiscard]] const ChangesInCell& changes() const noexcept { return changes_; }

 private:
  Index<3> cell_;
  std::array<ImageIndex, 8> owners_;
  std::vector<ImageIndex> own_;
  ChangesInCell changes_;
  std::array<const CubeFace*, faces_of_cell<3>> faces_;
};

}  // namespace breccia::gaps

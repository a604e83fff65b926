#include "discretisation/gaps/plane/cell_place.hpp"

#include <algorithm>

namespace breccia::gaps {

CellPlace::CellPlace(const GapGeometry<2>& geometry, const Index<2>& cell) : cell_(cell), owners_(), faces_() {
  for (int node = 0; node < CellShape<2>::nodes; ++node) {
    owners_[static_cast<std::size_t>(node)] = geometry.owners.of(this->node(node));
  }
  for (int face = 0; face < faces_of_cell<2>; ++face) {
    faces_[static_cast<std::size_t>(face)] = &geometry.faces.at(face_place(face));
  }
}

Index<2> CellPlace::node(int node) const noexcept {
  const auto corner = CellShape<2>::corner(node);
  return {cell_[0] + corner[0], cell_[1] + corner[1]};
}

FacePlace CellPlace::face_place(int face) const noexcept {
  return {node(node_of(face, 0)), 1 - normal(face)};
}

bool CellPlace::has_free_node() const noexcept {
  return std::ranges::find(owners_, no_image) != owners_.end();
}

bool CellPlace::has_one_owner() const noexcept {
  return !has_free_node() && nodes_of(owners_.front()) == CellShape<2>::nodes;
}

ImageIndex CellPlace::second_owner() const noexcept {
  const auto is_other = [&](ImageIndex owner) { return owner != owners_.front(); };
  const auto other = std::ranges::find_if(owners_, is_other);
  return other == owners_.end() ? no_image : *other;
}

int CellPlace::nodes_of(ImageIndex image) const noexcept {
  return static_cast<int>(std::ranges::count(owners_, image));
}

bool CellPlace::is_in_chain() const noexcept {
  if (has_free_node() || has_one_owner()) return false;
  if (nodes_of(owners_.front()) + nodes_of(second_owner()) != CellShape<2>::nodes) return false;
  return owners_[0] != owners_[3] || owners_[1] != owners_[2];
}

}  // namespace breccia::gaps

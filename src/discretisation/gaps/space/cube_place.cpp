#include "discretisation/gaps/space/cube_place.hpp"

#include <algorithm>

namespace breccia::gaps {

CubePlace::CubePlace(const GapGeometry<3>& geometry, const Index<3>& cell) : cell_(cell), owners_(), faces_() {
  for (int node = 0; node < CellShape<3>::nodes; ++node) {
    const auto owner = geometry.owners.of(this->node(node));
    owners_[static_cast<std::size_t>(node)] = owner;
    if (owner != no_image && std::ranges::find(own_, owner) == own_.end()) own_.push_back(owner);
  }
  for (int face = 0; face < faces_of_cell<3>; ++face) {
    faces_[static_cast<std::size_t>(face)] = &geometry.faces.at(face_place(face));
  }
  if (own_.size() < 2) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int node = 0; node < CellShape<3>::nodes; ++node) {
      if (is_upper(node, axis)) continue;
      changes_[edge_of_cell(static_cast<std::size_t>(node), axis)] =
          change_on_edge(geometry.images, geometry.owners, this->node(node), axis);
    }
  }
}

Index<3> CubePlace::node(int node) const noexcept {
  const auto corner = CellShape<3>::corner(node);
  return {cell_[0] + corner[0], cell_[1] + corner[1], cell_[2] + corner[2]};
}

CubeFacePlace CubePlace::face_place(int face) const noexcept {
  const auto normal = static_cast<std::size_t>(face / 2);
  auto first_node = cell_;
  first_node[normal] += face % 2;
  return {first_node, normal};
}

bool CubePlace::has_free_node() const noexcept {
  return std::ranges::find(owners_, no_image) != owners_.end();
}

}  // namespace breccia::gaps

#include "discretisation/gaps/plane/face_table.hpp"

namespace breccia::gaps {

FaceTable::FaceTable(const ParticleImages<2>& images, const Owners<2>& owners) : nodes_(images.nodes()) {
  std::int32_t next = 0;
  const auto number = [&](bool exists) { return exists ? next++ : GapCell<2>::none; };
  for_each_index(nodes_.begin, nodes_.end, [&](const Index<2>& node) {
    for (std::size_t along = 0; along < 2; ++along) {
      first_unknowns_.push_back(next);
      const bool is_in_box = node[along] < images.cells();
      const auto face = is_in_box ? make_face(images, owners, {node, along}) : Face{};
      const auto flow = number(face.has_flow());
      const auto first_slope = number(face.has_slope[0]);
      faces_.push_back({face, {flow, first_slope, number(face.has_slope[1])}});
    }
  });
  first_unknowns_.push_back(next);
}

const FaceTable::NumberedFace& FaceTable::numbered(const FacePlace& place) const noexcept {
  auto node = place.first_node;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const int along = nodes_.end[axis];
    node[axis] = (node[axis] % along + along) % along;  // an image has the face of its node in the box
  }
  return faces_[2 * nodes_.place_of(node) + place.along];
}

}  // namespace breccia::gaps

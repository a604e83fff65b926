#include "discretisation/gaps/face_table.hpp"

namespace breccia::gaps {

FaceTable::FaceTable(const DiscImages& discs, const Owners& owners) : cells_(discs.cells()) {
  std::int32_t next = 0;
  const auto number = [&](bool exists) { return exists ? next++ : GapCell::none; };
  for_each_index(Index<2>{}, Index<2>{cells_, cells_}, [&](const Index<2>& node) {
    for (std::size_t along = 0; along < 2; ++along) {
      first_unknowns_.push_back(next);
      auto face = make_face(discs, owners, {node, along});
      const auto flow = number(face.has_flow());
      const auto first_slope = number(face.has_slope[0]);
      faces_.push_back({face, {flow, first_slope, number(face.has_slope[1])}});
    }
  });
  first_unknowns_.push_back(next);
}

const FaceTable::NumberedFace& FaceTable::numbered(const FacePlace& place) const noexcept {
  std::size_t number = 0;
  for (std::size_t axis = 2; axis-- > 0;) {
    const int wrapped = (place.first_node[axis] % cells_ + cells_) % cells_;
    number = number * static_cast<std::size_t>(cells_) + static_cast<std::size_t>(wrapped);
  }
  return faces_[2 * number + place.along];
}

}  // namespace breccia::gaps

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "discretisation/gaps/plane/face.hpp"
#include "discretisation/gaps/plane/face_unknowns.hpp"

namespace breccia::gaps {

/// All faces of the cells of a box, and the numbers of their unknowns.
class FaceTable {
 public:
  FaceTable(const ParticleImages<2>& images, const Owners<2>& owners);

  /// A face in the box or on an image of it.
  [[nodiscard]] const Face& at(const FacePlace& place) const noexcept { return numbered(place).face; }
  /// The numbers of its flow and of its slopes; GapCell::none for those that it does not have.
  [[nodiscard]] const std::array<std::int32_t, unknowns_of_face>& unknowns(const FacePlace& place) const noexcept {
    return numbered(place).unknowns;
  }
  /// The nodes at which faces begin.
  [[nodiscard]] const IndexRange<2>& nodes() const noexcept { return nodes_; }
  /// By node and axis, where the numbers of the unknowns of a face begin, and last the number of all unknowns.
  [[nodiscard]] const std::vector<std::int32_t>& first_unknowns() const noexcept { return first_unknowns_; }

 private:
  struct NumberedFace {
    Face face;
    std::array<std::int32_t, unknowns_of_face> unknowns = {};
  };
  [[nodiscard]] const NumberedFace& numbered(const FacePlace& place) const noexcept;

  IndexRange<2> nodes_;
  std::vector<NumberedFace> faces_;  ///< node by node, the face along the first axis and that along the second
  std::vector<std::int32_t> first_unknowns_;
};

}  // namespace breccia::gaps

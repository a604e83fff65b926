#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "discretisation/gaps/space/cube_face.hpp"
#include "discretisation/gaps/space/cube_unknowns.hpp"

namespace breccia::gaps {

/// All faces of the cells of a box, and the numbers of the unknowns of gaps: node by node the flows through the faces
/// that begin at it, and its slopes.
class CubeFaces {
 public:
  CubeFaces(const ParticleImages<3>& images, const Owners<3>& owners);

  /// A face in the box or on an image of it.
  [[nodiscard]] const CubeFace& at(const CubeFacePlace& place) const noexcept;
  /// The number of the flow through a face; GapCell::none without one.
  [[nodiscard]] std::int32_t flow(const CubeFacePlace& place) const noexcept;
  /// The number of a slope of a node; GapCell::none where it does not have it.
  [[nodiscard]] std::int32_t slope(const Index<3>& node, const Slope& slope) const noexcept {
    return number_of(place_of(node), flows_of_node + slope.number());
  }

  /// The nodes at which faces begin.
  [[nodiscard]] const IndexRange<3>& nodes() const noexcept { return nodes_; }
  /// By node where the numbers of its unknowns begin, and last the number of all unknowns.
  [[nodiscard]] const std::vector<std::int32_t>& first_unknowns() const noexcept { return first_unknowns_; }

 private:
  /// The place among the nodes of the box of a node or of an image of it.
  [[nodiscard]] std::size_t place_of(Index<3> node) const noexcept;
  /// The number of one of the unknowns that a node may have, in their order.
  [[nodiscard]] std::int32_t number_of(std::size_t node, std::size_t unknown) const noexcept;

  static constexpr std::size_t flows_of_node = 3;

  IndexRange<3> nodes_;
  CubeFace plain_;                     ///< a face without a gap
  std::vector<CubeFace> faces_;        ///< the other faces
  std::vector<std::int32_t> numbers_;  ///< by node and axis: which of these a face is; none for a plain one
  std::vector<std::uint16_t> has_;     ///< by node: a bit for each unknown that it has
  std::vector<std::int32_t> first_unknowns_;
};

}  // namespace breccia::gaps

#include "discretisation/gaps/space/cube_faces.hpp"

#include <bit>

namespace breccia::gaps {
namespace {

bool is_plain(const CubeFace& face) noexcept {
  return !face.has_flow() && face.flux.of_slopes == decltype(face.flux.of_slopes){} &&
         face.flux.of_nodes == CubeFace{}.flux.of_nodes;
}

}  // namespace

CubeFaces::CubeFaces(const ParticleImages<3>& images, const Owners<3>& owners) : nodes_(images.nodes()) {
  std::size_t size = 1;
  for (const int along : nodes_.size()) size *= static_cast<std::size_t>(along);
  numbers_.assign(flows_of_node * size, GapCell<3>::none);
  has_.assign(size, 0);
  const auto set = [&](std::size_t node, std::size_t unknown) {
    has_[node] = static_cast<std::uint16_t>(has_[node] | 1U << unknown);
  };
  for_each_index(nodes_.begin, nodes_.end, [&](const Index<3>& node) {
    for (std::size_t normal = 0; normal < 3; ++normal) {
      const CubeFacePlace place = {node, normal};
      const auto face = make_face(images, owners, place);
      if (is_plain(face)) continue;
      numbers_[flows_of_node * place_of(node) + normal] = static_cast<std::int32_t>(faces_.size());
      faces_.push_back(face);
      if (face.has_flow()) set(place_of(node), normal);
      for (std::size_t of_face = 0; of_face < face.flux.of_nodes.size(); ++of_face) {
        for (std::size_t along = 0; along < 2; ++along) {
          if (!face.has_slope(of_face, along)) continue;
          set(place_of(place.node(of_face)), flows_of_node + Slope{normal, place.axis(along)}.number());
        }
      }
    }
  });
  std::int32_t next = 0;
  for (const auto has : has_) {
    first_unknowns_.push_back(next);
    next += std::popcount(has);
  }
  first_unknowns_.push_back(next);
}

const CubeFace& CubeFaces::at(const CubeFacePlace& place) const noexcept {
  const auto number = numbers_[flows_of_node * place_of(place.first_node) + place.normal];
  return number == GapCell<3>::none ? plain_ : faces_[static_cast<std::size_t>(number)];
}

std::int32_t CubeFaces::flow(const CubeFacePlace& place) const noexcept {
  return number_of(place_of(place.first_node), place.normal);
}

std::size_t CubeFaces::place_of(Index<3> node) const noexcept {
  for (std::size_t axis = 0; axis < node.size(); ++axis) {
    const int along = nodes_.end[axis];
    node[axis] = (node[axis] % along + along) % along;
  }
  return nodes_.place_of(node);
}

std::int32_t CubeFaces::number_of(std::size_t node, std::size_t unknown) const noexcept {
  const unsigned has = has_[node], before = has & ((1U << unknown) - 1U);
  if ((has >> unknown & 1U) == 0U) return GapCell<3>::none;
  return first_unknowns_[node] + std::popcount(before);
}

}  // namespace breccia::gaps

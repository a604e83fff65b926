#include "discretisation/gaps/space/face_parts.hpp"

#include <cmath>
#include <cstddef>

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

constexpr std::size_t nodes_of_face = 4;

Vector<2> corner(std::size_t node) noexcept {
  return {static_cast<double>(node & 1U), static_cast<double>(node >> 1U)};
}

/// The place on an edge up to which the parts of its nodes go.
Vector<2> end_of_parts(const ChangesOfOwner& changes, std::size_t node, std::size_t axis) noexcept {
  auto place = corner(node);
  place[axis] = changes[edge_from(node, axis)].value_or(0.5);
  return place;
}

/// The mean of the changes of owner; the middle of a face of one owner.
Vector<2> centre_of_parts(const ChangesOfOwner& changes) noexcept {
  Vector<2> sum{};
  int found = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (const std::size_t node : {std::size_t{0}, nodes_of_face - 1}) {
      if (!changes[edge_from(node, axis)]) continue;
      sum += end_of_parts(changes, node, axis);
      ++found;
    }
  }
  return found > 0 ? sum / found : Vector<2>{0.5, 0.5};
}

/// The area of the part of a face that goes with a node, and its first moment about the node.
struct Part {
  double area = 0.0;
  Vector<2> moment{};
};

Part part_of(const ChangesOfOwner& changes, std::size_t node, const Vector<2>& centre) noexcept {
  const auto origin = corner(node);
  const auto to_centre = centre - origin;
  Part part;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto to_end = end_of_parts(changes, node, axis) - origin;
    const double area = 0.5 * std::abs(cross(to_end, to_centre));
    part.area += area;
    part.moment += area / 3.0 * (to_end + to_centre);
  }
  return part;
}

}  // namespace

FaceFlux flux_through_face(const ChangesOfOwner& changes) {
  const auto centre = centre_of_parts(changes);
  FaceFlux flux;
  for (std::size_t node = 0; node < nodes_of_face; ++node) {
    const auto [area, moment] = part_of(changes, node, centre);
    flux.of_nodes[node] += area;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (changes[edge_from(node, axis)]) {
        flux.of_slopes[node][axis] = moment[axis];
      } else {
        const std::size_t step = std::size_t{1} << axis;
        flux.of_nodes[node | step] += moment[axis];
        flux.of_nodes[node & ~step] -= moment[axis];
      }
    }
  }
  return flux;
}

}  // namespace breccia::gaps

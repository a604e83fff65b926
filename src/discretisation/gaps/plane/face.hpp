#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "discretisation/gaps/owners.hpp"

namespace breccia::gaps {

/// A face of a cell, between two nodes that are neighbours along an axis; its normal is the other axis.
struct FacePlace {
  Index<2> first_node;
  std::size_t along;

  [[nodiscard]] std::size_t normal() const noexcept { return 1 - along; }
  /// A node on the line of the face: 0 is the first one of the face, 1 the second, -1 the one before.
  [[nodiscard]] Index<2> node(int steps) const noexcept {
    auto node = first_node;
    node[along] += steps;
    return node;
  }
  /// The line from the first node to the second.
  [[nodiscard]] GridLine<2> line() const noexcept {
    return {{static_cast<double>(first_node[0]), static_cast<double>(first_node[1])}, along};
  }
};

/// What passes through a face (theory, Eqs. 42d and 42e). The flux of a displacement u follows particles up to their
/// surfaces: F = of_nodes[0] u_A + of_nodes[1] u_B + of_slopes[0] theta_A + of_slopes[1] theta_B, with the
/// displacements u along the normal of both nodes and the slopes theta, along the face, of u in their particles.
struct Face {
  bool is_cross = false;  ///< whether both nodes belong to particles, not to one, with binder between them
  double split = 0.5;     ///< place between both particles of a cross face
  /// Binder beyond the ends of the face whose gap the face represents, less binder on it that others represent.
  double binder_outside = 0.0;
  double conductance = 0.0;  ///< c: binder with a shear modulus g flows with an energy g q^2 / (2 c); 0 without binder
  std::array<double, 2> of_nodes = {0.5, 0.5}, of_slopes = {};
  std::array<bool, 2> has_slope = {};

  [[nodiscard]] bool has_flow() const noexcept { return conductance > 0.0; }
  /// The flow per unknown: the energy of an unknown of 1 is that of a shear modulus, however narrow the gap.
  [[nodiscard]] double unit_of_flow() const noexcept { return std::sqrt(conductance); }
};

[[nodiscard]] Face make_face(const ParticleImages<2>& images, const Owners<2>& owners, const FacePlace& place);

/// Whether one node of a face is free and the other one, in binder, belongs to a particle: the end of a narrow gap.
[[nodiscard]] bool is_end_of_gap(const Owners<2>& owners, const FacePlace& place);

}  // namespace breccia::gaps

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "discretisation/gaps/owners.hpp"
#include "discretisation/gaps/space/face_parts.hpp"

namespace breccia::gaps {

/// A face of a cubic cell, by its lowest node and the axis normal to it. Its own axes are the other two in their order;
/// its nodes are in the order of CellShape<2>.
struct CubeFacePlace {
  Index<3> first_node;
  std::size_t normal;

  /// The axis of space that is the first or second axis of the face.
  [[nodiscard]] std::size_t axis(std::size_t along) const noexcept { return along < normal ? along : along + 1; }
  [[nodiscard]] Index<3> node(std::size_t number) const noexcept {
    auto node = first_node;
    node[axis(0)] += static_cast<int>(number & 1U);
    node[axis(1)] += static_cast<int>(number >> 1U);
    return node;
  }
  [[nodiscard]] Vector<3> centre() const noexcept;
  /// The line along an axis of the face, from a place on its other axis.
  [[nodiscard]] GridLine<3> line(std::size_t along, double place) const noexcept;
};

/// What passes through a face (docs/gaps-in-space.md): the flux of a displacement, which follows particles up to their
/// surfaces, and a flow.
struct CubeFace {
  FaceFlux flux = {.of_nodes = {0.25, 0.25, 0.25, 0.25}};
  double conductance = 0.0;  ///< c: binder with a shear modulus g flows with an energy g q^2 / (2 c); 0 without flow

  [[nodiscard]] bool has_flow() const noexcept { return conductance > 0.0; }
  /// The flow per unknown: the energy of an unknown of 1 is that of a shear modulus, however narrow the gap.
  [[nodiscard]] double unit_of_flow() const noexcept { return std::sqrt(conductance); }
  [[nodiscard]] bool has_slope(std::size_t node, std::size_t along) const noexcept {
    return flux.of_slopes[node][along] != 0.0;
  }
};

/// The face at a place. Faces of one owner, and those in binder that is wider than `widest_gap`, have the mean of their
/// nodes, and no flow.
[[nodiscard]] CubeFace make_face(const ParticleImages<3>& images, const Owners<3>& owners, const CubeFacePlace& place);

/// Width of the gaps [cells] up to which binder flows: wider ones do not need it.
inline constexpr double widest_gap = 4.0;

/// The change of owner on an edge of a cell from a node along an axis; nothing where both nodes have the same owner, or
/// one has none. It is not at a node, where a facet would lose an edge.
[[nodiscard]] std::optional<double> change_on_edge(const ParticleImages<3>& images, const Owners<3>& owners,
                                                   const Index<3>& node, std::size_t axis);

}  // namespace breccia::gaps

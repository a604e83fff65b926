#pragma once

#include <functional>
#include <span>

#include <Eigen/Core>

#include "breccia/microstructure/vector.hpp"

namespace breccia::gaps {

// Places and lengths are in units of the cell side.

/// The width of a gap between two particles in space, and its gradient, the sum of the normals of both.
struct GapWidth {
  double width;
  Vector<3> gradient;
};
using WidthAt = std::function<GapWidth(const Vector<3>&)>;

/// The binder between two particles on a polygon in the middle of their gap, the part of it in a cell.
struct Facet {
  /// Energy of its flow, per shear modulus of the binder: half of Q' resistance Q, where Q are the flows out through
  /// the edges of the polygon; edge k goes from corner k to the next one.
  Eigen::MatrixXd resistance;
  double slenderness;  ///< integral of dA / h: the force of sliding per shear modulus and displacement
  double volume;       ///< integral of h dA
};

/// The facet with these corners, three or more, in their order around it, by lubrication of the second order for a
/// parabolic profile. The flow is that of Raviart and Thomas of the lowest order on the triangles between the edges and
/// the centroid, with the same divergence in all of them (docs/gaps-in-space.md). A facet without area has no
/// resistance.
[[nodiscard]] Facet make_facet(std::span<const Vector<3>> corners, const WidthAt& width);

}  // namespace breccia::gaps

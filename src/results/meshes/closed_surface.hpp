#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "breccia/microstructure/convex_cell.hpp"
#include "breccia/microstructure/ellipsoid.hpp"
#include "breccia/microstructure/vector.hpp"

namespace breccia {

/// The surface of a particle as triangles, counter-clockwise from outside. Each edge belongs to two of them.
struct ClosedSurface {
  std::vector<Vector<3>> corners;  ///< positions [m]
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// The volume inside a surface [m^3].
[[nodiscard]] double enclosed_volume(const ClosedSurface& surface);

/// A ball of diameter 1 around the origin, as an icosahedron each of whose triangles is divided: the corners are on the
/// ball, and no edge is longer than `longest_edge`, a share of the diameter. Throws InputError unless this share is
/// from `shortest_longest_edge` to 1.
[[nodiscard]] ClosedSurface divided_icosahedron(double longest_edge);
inline constexpr double shortest_longest_edge = 0.005;

/// The unit ball of divided_icosahedron(), stretched to an ellipsoid, on which its corners are.
[[nodiscard]] ClosedSurface surface_of(const Ellipsoid& ellipsoid, const ClosedSurface& unit_ball);

/// The surface of a polyhedron at a place, with fans of triangles as its faces.
[[nodiscard]] ClosedSurface surface_of(const ConvexCell<3>& polyhedron, const Vector<3>& place);

}  // namespace breccia

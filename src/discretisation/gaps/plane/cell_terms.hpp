#pragma once

#include <vector>

#include "discretisation/gaps/plane/cell_place.hpp"
#include "discretisation/gaps/plane/channel.hpp"
#include "discretisation/gaps/plane/face_unknowns.hpp"

namespace breccia::gaps {

/// The flux out of a cell, without what flows, as a form of its unknowns.
[[nodiscard]] CellUnknowns<2> volume_change(const CellPlace& place);
/// Ties the slopes of the faces of a cell to their particles.
void tie_slopes(const GapGeometry<2>& geometry, const CellPlace& place, std::vector<SquareTerm<2>>& terms);
/// Adds the energy of the flow through the faces of a cell: half of the energy of each face.
void add_flow(const GapGeometry<2>& geometry, const CellPlace& place, std::vector<SquareTerm<2>>& terms);

/// The two faces of a cell in a chain through which its channel runs, in the order of the faces of a cell.
struct EndsOfChannel {
  int begin, end;
};
[[nodiscard]] EndsOfChannel ends_of_channel(const CellPlace& place) noexcept;
/// Adds the energy of the flow through a channel, and half of that through the other faces of its cell.
void add_flow_along(const GapGeometry<2>& geometry, const CellPlace& place, const Channel& channel,
                    std::vector<SquareTerm<2>>& terms);
/// Adds the stiffness of a particle that has three of the nodes of a cell in a chain.
void add_corner_of_particle(const GapGeometry<2>& geometry, const CellPlace& place, std::vector<SquareTerm<2>>& terms);

}  // namespace breccia::gaps

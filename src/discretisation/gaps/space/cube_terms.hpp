#pragma once

#include <optional>
#include <vector>

#include "discretisation/gaps/space/cube_place.hpp"
#include "discretisation/gaps/space/facet.hpp"

namespace breccia::gaps {

/// The flux out of a cell, without what flows, as a form of its unknowns.
[[nodiscard]] CellUnknowns<3> volume_change(const CubePlace& place);
/// Ties the slopes of the nodes of a cell to their particles.
void tie_slopes(const GapGeometry<3>& geometry, const CubePlace& place, std::vector<SquareTerm<3>>& terms);

/// The width of the gap between two particles.
[[nodiscard]] WidthAt width_between(const ParticleImages<3>& images, ImageIndex first, ImageIndex second);

/// The facet of a cell whose nodes belong to two particles, and the faces of the cell on which its edges lie.
struct FacetOfCell {
  Facet facet;
  std::vector<std::size_t> faces;  ///< by edge
};
/// The facet of a cell; nothing where the middle of the gap is not one polygon between two particles.
[[nodiscard]] std::optional<FacetOfCell> facet_of(const GapGeometry<3>& geometry, const CubePlace& place);

/// Adds the energy of the flow in a cell: in its facet, and half of the energy of each face without an edge of it.
void add_flow(const GapGeometry<3>& geometry, const CubePlace& place, const std::optional<FacetOfCell>& facet,
              std::vector<SquareTerm<3>>& terms);

}  // namespace breccia::gaps

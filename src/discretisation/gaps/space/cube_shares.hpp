#pragma once

#include <optional>

#include "discretisation/gaps/phase_shares.hpp"
#include "discretisation/gaps/space/cube_terms.hpp"

namespace breccia::gaps {

/// The phases of a cell in series, with the shares of binder of docs/gaps-in-space.md.
[[nodiscard]] CellShares shares_of_cell(const GapGeometry<3>& geometry, const CubePlace& place,
                                        const std::optional<FacetOfCell>& facet);

}  // namespace breccia::gaps

#pragma once

#include "discretisation/gaps/plane/cell_place.hpp"
#include "discretisation/gaps/plane/channel.hpp"

namespace breccia::gaps {

/// The shares of a cell outside channels.
struct SharesOutsideChannels {
  CellShares shares;
  bool is_one_phase = false;  ///< whether one phase fills the cell, and has it for itself
};

/// A cell of a channel: its binder resists sliding, and its volume change, with that of the channel.
[[nodiscard]] CellShares shares_of_channel(const GapGeometry<2>& geometry, const CellPlace& place,
                                           const Channel& channel);
/// Any other cell.
[[nodiscard]] SharesOutsideChannels shares_of_cell(const GapGeometry<2>& geometry, const CellPlace& place);

/// The share of the area of a cell in a particle [-].
[[nodiscard]] double share_of(const GapGeometry<2>& geometry, const CellPlace& place, ImageIndex image);

}  // namespace breccia::gaps

#pragma once

#include "discretisation/gaps/cell_place.hpp"
#include "discretisation/gaps/channel.hpp"
#include "discretisation/gaps/gap_cell.hpp"

namespace breccia::gaps {

/// The phases of a cell in series: what they are, their shares of its area, and their shares in series.
struct CellShares {
  Mixture mixture;
  std::vector<VolumeAndShear> shares;
  bool is_one_phase = false;  ///< whether one phase fills the cell, and has it for itself
};

/// A cell of a channel: its binder resists sliding, and its volume change, with that of the channel.
[[nodiscard]] CellShares shares_of_channel(const GapGeometry& geometry, const CellPlace& place, const Channel& channel);
/// Any other cell.
[[nodiscard]] CellShares shares_of_cell(const GapGeometry& geometry, const CellPlace& place);

/// The share of the area of a cell in a particle [-].
[[nodiscard]] double share_of(const GapGeometry& geometry, const CellPlace& place, ImageIndex image);

}  // namespace breccia::gaps

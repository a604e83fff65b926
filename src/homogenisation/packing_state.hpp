#pragma once

#include "breccia/checkpoint/state.hpp"
#include "breccia/microstructure/packing.hpp"

namespace breccia {

/// Writes an unfinished packing to a state, and restores it.
void save(StateWriter& state, const PackingState<2>& packing);
PackingState<2> read_packing_state(const StateReader& state);

}  // namespace breccia

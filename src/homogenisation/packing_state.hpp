#pragma once

#include "breccia/checkpoint/state.hpp"
#include "breccia/microstructure/packing.hpp"

namespace breccia {

/// Leaves a packing on its way in a state, and takes it up.
void save(StateWriter& state, const PackingState<2>& packing);
PackingState<2> read_packing_state(const StateReader& state);

}  // namespace breccia

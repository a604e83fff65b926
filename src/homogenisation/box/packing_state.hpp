#pragma once

#include "breccia/microstructure/packing.hpp"

#include "checkpoint/state.hpp"

namespace breccia {

/// Writes an unfinished packing to a state, and restores it. Instantiated for 2 and 3 dimensions.
template <int dim>
void save(StateWriter& state, const PackingState<dim>& packing);
template <int dim>
PackingState<dim> read_packing_state(const StateReader& state);

}  // namespace breccia

#pragma once

#include "breccia/checkpoint/state.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"

namespace breccia {

/// Leaves a microstructure in a state, and reads it again. Throws FileError where the state is not one of discs in a
/// box.
void save(StateWriter& state, const StageMicrostructure& microstructure);
StageMicrostructure read_stage_microstructure(const StateReader& state);

}  // namespace breccia

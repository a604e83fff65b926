#pragma once

#include "breccia/homogenisation/stage_microstructure.hpp"

#include "checkpoint/state.hpp"

namespace breccia {

/// Writes a microstructure to a state. Throws FileError.
void save(StateWriter& state, const StageMicrostructure& microstructure);
/// Reads the microstructure of a stage from a state. Throws FileError if the state does not have valid discs of its
/// fillers in a box.
StageMicrostructure read_stage_microstructure(const StateReader& state, const Stage& stage);

}  // namespace breccia

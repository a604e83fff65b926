#pragma once

#include "breccia/discretisation/phase.hpp"

namespace breccia {

/// Phases of a stage, in the order of its list of materials.
constexpr PhaseIndex matrix_phase = 0;
constexpr PhaseIndex filler_phase = 1;

}  // namespace breccia

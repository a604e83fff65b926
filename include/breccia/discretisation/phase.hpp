#pragma once

#include <cstdint>

namespace breccia {

/// Number of a phase: the index of its material in the list that goes with a discretisation.
using PhaseIndex = std::uint8_t;

/// In place of a phase: there is no material here.
constexpr PhaseIndex no_phase = 255;

}  // namespace breccia

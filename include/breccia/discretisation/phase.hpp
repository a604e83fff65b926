#pragma once

#include <cstdint>

namespace breccia {

/// Number of a phase, or of a mixture of several phases (discretisation/mixture.hpp): the index of its material in the
/// list that goes with a discretisation. A box of several fillers has thousands of mixtures.
using PhaseIndex = std::uint16_t;

/// The value in place of a phase where there is no material.
constexpr PhaseIndex no_phase = 65535;

}  // namespace breccia

#pragma once

#include "breccia/homogenisation/stage_microstructure.hpp"

namespace breccia {

/// Name of the wall time of a packing in states.
inline constexpr auto packing_seconds_name = "/seconds";

/// Measures the fraction, the interface and the gaps of a microstructure.
void measure(StageMicrostructure& result);

}  // namespace breccia

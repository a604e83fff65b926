#pragma once

#include "breccia/homogenisation/stage_microstructure.hpp"

namespace breccia {

/// Name of the wall time of a packing in states.
inline constexpr auto packing_seconds_name = "/seconds";

/// Measures the fractions, the interface and the gaps of the microstructure of a stage. The size deviations of the
/// fillers that are known already are kept.
void measure(const Stage& stage, StageMicrostructure& result);

}  // namespace breccia

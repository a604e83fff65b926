#pragma once

#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// The temperature shift of plasticised Estane, as in the examples of PBX-9501: c1 [1], c2 [K], reference temperature
/// [K].
inline constexpr WilliamsLandelFerry estane = {6.5, 120.0, 292.15};

}  // namespace breccia

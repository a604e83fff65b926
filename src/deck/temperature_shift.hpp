#pragma once

#include <optional>

#include "breccia/io/deck.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// Reads `temperature_shift` of a material; nothing if it is missing or after a mistake was reported.
std::optional<TemperatureShift> read_temperature_shift(const Section& material);

}  // namespace breccia

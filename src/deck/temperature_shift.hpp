#pragma once

#include <optional>

#include "breccia/viscoelasticity/temperature_shift.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads `temperature_shift` of a material; nothing after a mistake was reported. `measured` is the law of its measured
/// moduli, which `law = "measured"` stands for. Without `temperature_shift` it holds at its reference temperature.
std::optional<TemperatureShift> read_temperature_shift(const Section& material,
                                                       const std::optional<ShiftLaw>& measured);

}  // namespace breccia

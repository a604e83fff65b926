#pragma once

#include <vector>

#include "checkpoint/state.hpp"

namespace breccia {

/// Writes the times [s] of the fields that a sink has stored to the state of a finished test, and reads them again.
void save_field_times(StateWriter& state, const std::vector<double>& times);
std::vector<double> read_field_times(const StateReader& state);

}  // namespace breccia

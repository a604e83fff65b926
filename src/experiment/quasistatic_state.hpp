#pragma once

#include "breccia/checkpoint/state.hpp"
#include "breccia/experiment/quasistatic_test.hpp"

namespace breccia {

/// What save_result has left.
QuasistaticTestResult read_quasistatic_result(const StateReader& state);

}  // namespace breccia

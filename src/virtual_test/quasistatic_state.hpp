#pragma once

#include "breccia/checkpoint/state.hpp"
#include "breccia/virtual_test/quasistatic_test.hpp"

namespace breccia {

/// What save_result has left.
QuasistaticTestResult read_quasistatic_result(const StateReader& state);

}  // namespace breccia

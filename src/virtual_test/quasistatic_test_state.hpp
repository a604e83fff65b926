#pragma once

#include "checkpoint/state.hpp"
#include "virtual_test/quasistatic_test.hpp"

namespace breccia {

/// Writes a result, without its fields, as the state of a finished test.
void save_result(StateWriter& state, const QuasistaticTestResult& result);
/// Reads the result of a finished test. Throws FileError when the state does not hold one.
QuasistaticTestResult read_quasistatic_result(const StateReader& state);

}  // namespace breccia

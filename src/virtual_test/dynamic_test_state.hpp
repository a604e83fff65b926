#pragma once

#include "checkpoint/state.hpp"
#include "virtual_test/dynamic_test.hpp"

namespace breccia {

/// Writes a result, without its fields, as the state of a finished test. run_dynamic_test() returns at once with the
/// result when it finds such a state.
void save_result(StateWriter& state, const DynamicTestResult& result);

}  // namespace breccia

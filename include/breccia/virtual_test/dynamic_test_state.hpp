#pragma once

#include "breccia/checkpoint/state.hpp"
#include "breccia/virtual_test/dynamic_test.hpp"

namespace breccia {

/// Writes a result, without its fields, as the state of a finished test, from which run_dynamic_test() returns at once.
void save_result(StateWriter& state, const DynamicTestResult& result);

}  // namespace breccia

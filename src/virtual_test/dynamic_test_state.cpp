#include "virtual_test/dynamic_test_state.hpp"

#include <vector>

#include "discretisation/point_fields_state.hpp"
#include "virtual_test/dynamic_state.hpp"

namespace breccia {

void save_result(StateWriter& state, const DynamicTestResult& result) {
  save_domains(state, result.domains);
  save(state, "/fields", Grid<2>(), {});
}

}  // namespace breccia

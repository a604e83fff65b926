#pragma once

#include <vector>

#include "breccia/checkpoint/state.hpp"
#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Leaves the names of files with fields in the state of a finished test, and reads them again.
void save(StateWriter& state, const std::vector<FieldRecord>& fields);
std::vector<FieldRecord> read_field_records(const StateReader& state);

}  // namespace breccia

#pragma once

#include <vector>

#include "breccia/checkpoint/state.hpp"
#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Writes the names of files with fields to the state of a finished test, and reads them.
void save(StateWriter& state, const std::vector<FieldRecord>& fields);
std::vector<FieldRecord> read_field_records(const StateReader& state);

}  // namespace breccia

#pragma once

#include <string_view>
#include <vector>

#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// Throws InputError, naming the test, where the times are not positive and rising, or those of fields not within them
/// and rising.
void require_times(std::string_view test, const TimeWindow& times, const std::vector<double>& field_times);

}  // namespace breccia

#pragma once

#include <string_view>
#include <vector>

#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// Throws InputError, with the name of the test, unless the times [s] are positive and rising, the curve has at least
/// one point a decade, and the field times are rising and within the times.
void require_times(std::string_view test, const TimeWindow& times, int points_per_decade,
                   const std::vector<double>& field_times);

}  // namespace breccia

#pragma once

#include <vector>

#include "breccia/virtual_test/dynamic_test.hpp"

namespace breccia {

/// Joins the valid windows of the domains, in order, at logarithmic times: cut by validity, blended in log time where
/// two are valid. Throws NumericalError where the domains leave a gap.
Curve stitch(const std::vector<TimeDomain>& domains, const TimeWindow& times, int points_per_decade);

/// The overlaps of neighbouring domains, with their mismatch at logarithmic times.
std::vector<Overlap> compare_overlaps(const std::vector<TimeDomain>& domains, int points_per_decade);

}  // namespace breccia

#pragma once

#include <vector>

#include "virtual_test/dynamic_test.hpp"

namespace breccia {

/// Joins the valid windows of the domains, in their order, at logarithmic times; blends two domains in log time where
/// both are valid. Throws NumericalError if the domains leave a gap.
Curve stitch(const std::vector<TimeDomain>& domains, const TimeWindow& times, int points_per_decade);

/// The overlaps of neighbouring domains; the mismatch is evaluated at logarithmic times.
std::vector<Overlap> compare_overlaps(const std::vector<TimeDomain>& domains, int points_per_decade);

}  // namespace breccia

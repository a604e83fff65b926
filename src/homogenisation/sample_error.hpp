#pragma once

#include <optional>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/test_load.hpp"

namespace breccia {

/// The error of a modulus that is found from one periodic box in place of all of its make [-]: twice the standard
/// deviation from box to box that a rule lets expect (theory, Eq. 43h). `stiffening` is the modulus over that of the
/// matrix. Nothing for a sample without a rule, and for fewer particles than it was measured with.
std::optional<double> sample_error(const ErrorRules& rules, int dimensions, TestLoad load, double stiffening);

/// The sample error of the mean of both shears of a box of the plane [-]: that of the rule, or down to half of it where
/// the shears have been no further apart than `distance` so far (theory, Eq. 43i).
double narrowed_by_shears(double rule, double distance);

}  // namespace breccia

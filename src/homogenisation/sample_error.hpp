#pragma once

#include <optional>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/test_load.hpp"

namespace breccia {

/// The error of a modulus that is found from one periodic box in place of all of its make [-]: twice the standard
/// deviation from box to box that a rule lets expect (theory, Eq. 43h). `stiffening` is the modulus over that of the
/// matrix. Nothing for a sample without a rule, and for fewer particles than it was measured with.
std::optional<double> sample_error(const ErrorRules& rules, int dimensions, TestLoad load, double stiffening);

/// The largest error of the mean of both shears of a box of the plane to be expected [-] where these have been no further
/// apart than this so far (theory, Eq. 43i).
double sample_error_of_shears(double distance);

}  // namespace breccia

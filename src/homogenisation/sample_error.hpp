#pragma once

#include <optional>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/moduli.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/test_load.hpp"

namespace breccia {

/// The modulus of a test of a material, the bulk modulus as the bulk test has it [Pa].
double modulus_under(TestLoad load, const Moduli& moduli, int dimensions);

/// The error of a modulus that is found from one box in place of all of its make [-]: twice the standard deviation from
/// box to box that a rule lets expect (theory, Eq. 43h). `stiffening` is the modulus over that of the matrix. Nothing
/// for a sample without a rule, for fewer particles than it was measured with, and for other boundaries than periodic
/// ones, which act on the particles near them.
std::optional<double> sample_error(const ErrorRules& rules, int dimensions, Boundary boundary, TestLoad load,
                                   double stiffening);

/// The sample error of the mean of both shears of a box of the plane [-]: that of the rule, or down to half of it where
/// the shears have been no further apart than `distance` so far (theory, Eq. 43i).
double narrowed_by_shears(double rule, double distance);

}  // namespace breccia

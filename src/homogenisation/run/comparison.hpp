#pragma once

#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/measurement.hpp"

namespace breccia {

/// The comparisons of a stage with those of the measurements that are of it: of its preferred tests under the load of
/// its shear modulus, of those in bulk for a bulk modulus in three dimensions, and of both for a Young's modulus, and
/// for a bulk modulus in the plane (theory, Eqs. 23a and 23b). Complex moduli are compared for the preferred method.
std::vector<Comparison> compare(const std::vector<Measurement>& measurements, const StageFindings& stage,
                                TestLoad shear);

/// The measurements that a stage was compared with, as far as the comparisons tell them: curves through the measured
/// moduli, of two samples at least, and the measured complex moduli.
std::vector<Measurement> measurements_of(const std::string& stage, const std::vector<Comparison>& comparisons);

}  // namespace breccia

#pragma once

#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/measurement.hpp"

namespace breccia {

/// The comparisons of a stage with those of the measurements that are of it: of its preferred tests under one load,
/// that of its shear modulus, and for a measured bulk or Young's modulus of these and the tests in bulk (theory, Eqs.
/// 23a and 23b). Complex moduli are compared for the preferred method.
std::vector<Comparison> compare(const std::vector<Measurement>& measurements, const StageFindings& stage,
                                TestLoad shear);

/// The measurements that a stage was compared with, as far as the comparisons tell them: curves through the measured
/// moduli, of two samples at least, and the measured complex moduli.
std::vector<Measurement> measurements_of(const std::string& stage, const std::vector<Comparison>& comparisons);

}  // namespace breccia

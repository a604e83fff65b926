#pragma once

#include <vector>

#include "breccia/assessment/assess.hpp"
#include "breccia/assessment/calibrate_inputs.hpp"
#include "breccia/assessment/observation.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The curves that the last stage of a study will have.
CurvesOfStudy curves_of(const Study& study);

/// The largest error that a study states of what was observed [-]; 0 where one of these is not known.
double stated_error(const std::vector<SampledCurve>& curves, const std::vector<Observation>& observations);

}  // namespace breccia

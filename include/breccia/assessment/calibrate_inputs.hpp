#pragma once

#include <vector>

#include "breccia/assessment/assess.hpp"
#include "breccia/assessment/calibrate.hpp"
#include "breccia/assessment/observation.hpp"
#include "breccia/deckfile/uncertain_input.hpp"

namespace breccia {

/// Finds the uncertain inputs of a study from measurements of its composite, by Bayes' rule as calibrate() does, but
/// with polynomials in the inputs that follow the curves of samples (theory, section 20): inputs that change the box
/// may be among them. What the deck says of the inputs is what is known beforehand. `model_deviation` is the relative
/// standard deviation of the composite from its model at all times [-]; the error of the polynomials is added to it.
/// Throws InputError for inputs of choices, and observations that the curves do not have; and as calibrate().
Calibration calibrate_inputs(const std::vector<UncertainInput>& inputs, const AssessmentDesign& design,
                             const std::vector<SampledCurve>& curves, const std::vector<Observation>& observations,
                             double model_deviation, const CalibrationOptions& options);

}  // namespace breccia

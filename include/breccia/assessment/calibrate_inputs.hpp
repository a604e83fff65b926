#pragma once

#include <vector>

#include "breccia/assessment/assess.hpp"
#include "breccia/assessment/calibrate.hpp"
#include "breccia/assessment/observation.hpp"
#include "breccia/deckfile/uncertain_input.hpp"

namespace breccia {

/// The curves that a study has.
struct CurvesOfStudy {
  bool are_over_frequency = false;
  bool have_bulk = false;  ///< whether the load bulk was tested
  double first = 0.0;      ///< first time [s] or angular frequency [rad/s]
  double last = 0.0;       ///< last time [s] or angular frequency [rad/s]
};

/// Throws InputError, with a line for each mistake: an input of choices, which polynomials do not follow; an
/// observation of another kind than these curves, of a modulus in bulk without such a test, at a temperature, outside
/// of their times.
void require_observable(const std::vector<UncertainInput>& inputs, const std::vector<Observation>& observations,
                        const CurvesOfStudy& curves);

/// Finds the uncertain inputs of a study from measurements of its composite, by Bayes' rule as calibrate() does, but
/// with polynomials in the inputs that follow the curves of samples (theory, section 20): inputs that change the box
/// may be among them. What the deck says of the inputs is what is known beforehand. `model_deviation` is the relative
/// standard deviation of the composite from its model at all times [-]; the error of the polynomials is added to it.
/// Throws InputError as require_observable() and calibrate().
Calibration calibrate_inputs(const std::vector<UncertainInput>& inputs, const AssessmentDesign& design,
                             const std::vector<SampledCurve>& curves, const std::vector<Observation>& observations,
                             double model_deviation, const CalibrationOptions& options);

}  // namespace breccia

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/assessment/calibrate_inputs.hpp"
#include "breccia/deck/deck_assessment.hpp"

#include "deck/asked_observations.hpp"

namespace breccia {

/// The inputs of a deck as measurements show them, and what they were found from.
struct CalibratedInputs {
  std::vector<Observation> observations = {};
  Calibration result = {};
  std::vector<std::string> notes = {};  ///< how data were understood, where that is not plain
};

/// Reads measured values of the composite and finds the uncertain inputs of a deck from them, by samples of the
/// posterior. `model_error` is the error of the moduli [-]; nothing: the largest that the study states. It is taken as
/// twice its standard deviation. Throws InputError, with a line for each mistake in all files, and as
/// calibrate_inputs().
CalibratedInputs calibrate_inputs(const DeckAssessment& deck, const std::vector<SampledCurve>& curves,
                                  const AskedObservations& measured, std::optional<double> model_error);

}  // namespace breccia

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/assessment/calibrate_inputs.hpp"
#include "breccia/deck/deck_assessment.hpp"

#include "deck/asked_observations.hpp"

namespace breccia {

/// Measured values of the composite of a deck, and the error of its model.
struct MeasuredComposite {
  std::vector<Observation> observations = {};
  Noise noise = Noise::relative;
  std::optional<double> model_error = {};  ///< of the moduli [-]; nothing: the largest that the study states
  std::vector<std::string> notes = {};     ///< how data were understood, where that is not plain
};

/// Reads measured values of the composite of a deck, before anything of it is solved. Throws InputError, with a line
/// for each mistake in all files, and where a deck cannot be compared with them (require_observable).
MeasuredComposite read_measured_composite(const DeckAssessment& deck, const AskedObservations& asked,
                                          std::optional<double> model_error);

/// Finds the uncertain inputs of a deck from measured values, by samples of the posterior. An error of the model is
/// taken as twice its standard deviation. Throws as calibrate_inputs() with a deviation.
Calibration calibrate_inputs(const DeckAssessment& deck, const std::vector<SampledCurve>& curves,
                             const MeasuredComposite& measured);

}  // namespace breccia

#pragma once

#include <string>
#include <vector>

#include "breccia/assessment/calibrate.hpp"

namespace breccia {

/// The warning where the error of a model is not known, and an interval lacks it.
inline constexpr auto unknown_model_error =
    "the error of the model is not known and not in the intervals; state the error of the model";

/// The remarks on a calibration, a line each: how far the predictions are from the data and where, noise that was
/// estimated, pairs of unknowns that the data hardly separate, unknowns of which only the prior is known, data that the
/// model does not follow, a model that is off by more than its error, samples that are too few.
std::vector<std::string> remarks_on(const Calibration& calibration, const std::vector<Observation>& observations,
                                    Noise noise);

}  // namespace breccia

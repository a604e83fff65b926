#pragma once

#include <string>
#include <vector>

#include "breccia/assessment/calibrate.hpp"

#include "assessment/observed_model.hpp"

namespace breccia {

/// Warnings where the materials at these scores, or with a number at an end of its interval, are outside of what the
/// run of a composite has sampled, so that its reduced response does not hold at the times and temperatures
/// of the observations. Terms of spectra are not moved to the
/// ends of their intervals: a single term does not describe a spectrum.
std::vector<std::string> warnings_on_coverage(const ObservedModel& model, const Eigen::VectorXd& scores,
                                              const std::vector<Estimate>& estimates);

}  // namespace breccia

#pragma once

#include <string>
#include <vector>

#include "breccia/assessment/calibrate.hpp"

namespace breccia::cli {

/// What is known of a number a priori in words: "5.84 GPa +- 600 MPa", "1, within a factor 10", "0 to 0.5".
std::string in_words(const Distribution& distribution, const std::string& unit);

/// What a calibration has found: a line for each estimate, with its interval, what was known before and what the data
/// have taught.
std::string table_of_estimates(const std::vector<Estimate>& estimates);

}  // namespace breccia::cli

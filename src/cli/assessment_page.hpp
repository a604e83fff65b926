#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/assessment/assess.hpp"
#include "breccia/assessment/calibrate.hpp"
#include "breccia/assessment/observation.hpp"
#include "breccia/study/tests.hpp"

namespace breccia::cli {

/// What the page of an assessment says besides its numbers.
struct AssessmentPage {
  std::string title;
  std::string source;  ///< deck and samples in words
  Abscissa abscissa = Abscissa::time;
  std::vector<bool> change_the_box = {};        ///< by input
  std::vector<Observation> measured = {};       ///< the measurements
  std::optional<Calibration> calibration = {};  ///< the inputs as measurements show them
};

/// The page of an assessment as an HTML document that needs neither other files nor a network.
std::string assessment_page(const AssessmentPage& page, const Assessment& assessment);

}  // namespace breccia::cli

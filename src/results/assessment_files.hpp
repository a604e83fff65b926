#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "breccia/assessment/assess.hpp"
#include "breccia/study/tests.hpp"

namespace breccia {

/// The directory for the files of an assessment, and its origin.
struct AssessmentDestination {
  std::filesystem::path directory;
  std::string source;                ///< deck and samples in words
  std::vector<std::string> studies;  ///< hashes of the studies that were solved
  std::string page;                  ///< the page of the assessment, an HTML document
  bool overwrite = false;            ///< whether another assessment may be replaced
};

/// The name of an input without the first step of its path: "hmx.shear".
std::string short_name(const UncertainInput& input);

/// Writes `report.html`, `bands.csv`, `sensitivity.csv`, `inputs.csv`, for each curve `bands_<curve>.svg` and
/// `sensitivity_<curve>.svg`, and `assess.json`, with the origin, to a directory, which is created if it is missing.
/// Returns the names of the files. Throws InputError if that would replace files that Breccia did not write or, without
/// `overwrite`, another assessment; FileError.
std::vector<std::string> write_assessment(const AssessmentDestination& destination, const Assessment& assessment,
                                          Abscissa abscissa);

}  // namespace breccia

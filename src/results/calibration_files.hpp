#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/assessment/calibrate.hpp"

namespace breccia {

/// The directory for the files of a calibration, and its origin.
struct CalibrationDestination {
  std::filesystem::path directory;
  std::string source;                         ///< composites, data and unknowns in words
  std::vector<std::filesystem::path> inputs;  ///< the files of the data
  std::vector<std::string> studies;           ///< hashes of the studies of the composites
  bool overwrite = false;                     ///< whether another calibration may be replaced
};

/// The measurements of a calibration and the names of the composites, in their order.
struct CalibrationData {
  const std::vector<Observation>& observations;
  std::vector<std::string> composites;
};

/// Writes `estimates.csv`, `correlations.csv`, `predictions.csv`, `predictions.svg`, the materials that were found
/// (write_material) and `calibrate.json`, with the origin, to a directory, which is created if it is missing. Returns
/// the names of the files. Throws InputError if that would replace one of the inputs, files that Breccia did not write
/// or, without `overwrite`, another calibration; FileError.
std::vector<std::string> write_calibration(const CalibrationDestination& destination, const CalibrationData& data,
                                           const Calibration& calibration);

}  // namespace breccia

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/results/frequency_rows.hpp"

namespace breccia {

/// The directory for the curves of a response, and the origin of the curves.
struct ResponseDestination {
  std::filesystem::path directory;
  std::string matrix;                         ///< description of the new matrix
  std::string study;                          ///< hash of the study with the reduced responses
  std::vector<std::filesystem::path> inputs;  ///< the files that the curves were computed from
  FrequencyRows rows = {};                    ///< the frequencies of the dynamic moduli
  bool overwrite = false;  ///< whether curves with another matrix, study, stage or time window may be replaced
};

/// Writes `curves.csv`, `prony.csv`, `quality.csv`, `compliance.csv` (for creep tests), the tables of
/// comparisons and `respond.json`, with the
/// origin of the curves, to a directory, which is created if it is missing. Throws InputError if that would replace one
/// of the inputs, results of a study, files that Breccia did not write, or, without `overwrite`, curves from other
/// inputs. Throws FileError.
void write_response_curves(const ResponseDestination& destination, const std::vector<StageResult>& stages);

}  // namespace breccia

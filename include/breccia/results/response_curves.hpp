#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Where the curves of a response go.
struct ResponseDestination {
  std::filesystem::path directory;
  std::string matrix;                         ///< the new matrix, in words
  std::string study;                          ///< hash of the study whose responses answer
  std::vector<std::filesystem::path> inputs;  ///< the files from which the curves come
  bool overwrite = false;                     ///< may curves from other files or another matrix be replaced?
};

/// Writes `curves.csv`, `prony.csv`, `quality.csv` and, of creep tests, `compliance.csv` to a directory, which is made,
/// and `respond.json`, which tells what they come from. Throws InputError where that would replace one of the inputs,
/// results of a study, files that Breccia did not write, or curves from other inputs that are not to be overwritten.
void write_response_curves(const ResponseDestination& destination, const std::vector<StageResult>& stages);

}  // namespace breccia

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/study/run.hpp"

namespace breccia {

/// Writes `microstructure.csv` and `microstructure.svg` of a stage.
void write_microstructure(const std::filesystem::path& directory, const Stage& stage,
                          const StageMicrostructure& microstructure);

/// Names of the files that hold curves: those that write_curves may write.
std::vector<std::string> curve_files();

/// Writes `curves.csv` and `prony.csv`, and where there is something to put in `compliance.csv`, `extrapolation.csv`
/// and `quality.csv`: all tests of all stages.
void write_curves(const std::filesystem::path& directory, const StudyResult& result);

/// Writes `study.json`: how every number was made.
void write_provenance(const std::filesystem::path& directory, const Study& study, const StudyResult& result);

}  // namespace breccia

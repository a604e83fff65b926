#pragma once

#include <filesystem>

#include "breccia/study/run.hpp"

namespace breccia {

/// Makes a directory for results. Throws FileError.
void make_directory(const std::filesystem::path& directory);

/// Removes a file if it is there. Throws FileError.
void remove_file(const std::filesystem::path& file);

/// Writes `microstructure.csv` and `microstructure.svg` of a stage.
void write_microstructure(const std::filesystem::path& directory, const Stage& stage,
                          const StageMicrostructure& microstructure);

/// Which time domain a history is of.
struct HistoryName {
  Boundary boundary;
  Load load;
  int cells;           ///< per side
  std::size_t number;  ///< from 1
};

/// Writes the history of one time domain as `<load>-<boundary>-dynamic-<cells>-<number>.h5`.
void write_history(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                   const HistoryName& name, const TimeDomain& domain);

/// Writes `fields.vtkhdf` of a stage: the points at the end of a test.
void write_fields(const std::filesystem::path& directory, const Grid& grid, const PointFields& fields);

/// Writes `curves.csv` and `prony.csv`, and where there is something to put in `compliance.csv` and
/// `extrapolation.csv`: all tests of all stages.
void write_curves(const std::filesystem::path& directory, const StudyResult& result);

/// Writes `study.json`: how every number was made.
void write_provenance(const std::filesystem::path& directory, const Study& study, const StudyResult& result);

}  // namespace breccia

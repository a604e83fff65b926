#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/campaign/run_observer.hpp"
#include "breccia/checkpoint/checkpoint_schedule.hpp"
#include "breccia/homogenisation/solve.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Options of a run in a directory.
struct RunOptions {
  SolveOptions solve = {};
  bool resume = false;                  ///< resume from the checkpoints of an earlier run
  bool overwrite = false;               ///< replace results of other studies when the new ones are complete
  CheckpointSchedule checkpoints = {};  ///< when a calculation saves its state, and when it ends early
  /// Hashes of the records of earlier results that may be replaced without `overwrite` (used by a sweep).
  std::vector<std::string> replaceable = {};
};

/// Solves a study (solve) and writes the results (docs/results.md) to a directory, which is created if it is missing.
/// No file is ever incomplete. Earlier results in the directory are kept until the new ones, which are written to its
/// subdirectory `unfinished`, are complete. If the run ends early, finished results and checkpoints are kept; another
/// run can resume from them, with bitwise identical results. Throws InputError (also if it would replace or resume
/// results of another study or version without `overwrite`; DirectoryInUse if another process writes to the directory),
/// NumericalError, FileError or Interrupted.
StudyResult run_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options = {},
                      const RunObserver& observer = {});

}  // namespace breccia

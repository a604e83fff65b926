#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/homogenisation/solve.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Functions that are called while a study is run in a directory.
struct RunObserver : StudyObserver {
  /// Results that replace earlier ones are written to this directory until they are whole.
  std::function<void(const std::filesystem::path&)> writes_beside = {};
  /// Another task of a sweep has computed this stage already; its files are in this directory.
  std::function<void(const StageResult&, const std::filesystem::path&)> taken_over = {};
  /// The reduced responses of this task of a sweep gave the stage at another temperature, without fields.
  std::function<void(const StageResult&, const std::string& task)> answered = {};
  /// What a user should know of files: those that were found and left aside, plots that gnuplot could not draw.
  std::function<void(const std::string&)> noted = {};
};

/// How a study is run in a directory.
struct RunOptions {
  SolveOptions solve = {};
  bool resume = false;                  ///< go on from the checkpoints of an earlier run
  bool overwrite = false;               ///< replace results of other studies, once the new ones are whole
  CheckpointSchedule checkpoints = {};  ///< when a calculation leaves its state, and when it ends early
  /// Earlier results that may be replaced without `overwrite`: hashes of their records, as a sweep has found them.
  std::vector<std::string> replaceable = {};
};

/// Solves a study (solve) and writes the results (docs/results.md) to a directory, which is made. Every
/// file appears whole or not at all. Where earlier results are in the directory, they stay until the new ones are
/// whole, which are written to its subdirectory `unfinished` meanwhile. What is done when the run ends early stays, and
/// with it checkpoints, from which another run goes on to the same bits. Throws InputError, also where it would replace
/// or go on from results of another study or version and is not to overwrite them, NumericalError, FileError or
/// Interrupted.
StudyResult run_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options = {},
                      const RunObserver& observer = {});

}  // namespace breccia

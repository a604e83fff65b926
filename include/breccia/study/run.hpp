#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "breccia/experiment/dynamic_test.hpp"
#include "breccia/study/microstructures.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// One virtual test of one stage, done.
struct TestResult {
  Load load = Load::shear;
  DynamicTestResult dynamic;
};

/// One stage, done as far as `tests` tell.
struct StageResult {
  std::string name;
  int cells = 0;
  std::size_t points = 0;
  double point_fraction = 0.0;  ///< share of the material points that are filler [-]
  StageMicrostructure microstructure;
  std::vector<TestResult> tests;
  std::vector<std::string> warnings;  ///< what makes the results doubtful
};

struct StudyResult {
  std::vector<StageResult> stages;
};

/// Those who follow a running study. What they throw ends it.
struct StudyObserver {
  std::function<bool(const Stage&, const PackingProgress&)> packing = {};
  std::function<void(const StageResult&)> packed = {};
  std::function<void(const Stage&, Load, const DynamicProgress&)> progress = {};
  std::function<void(const Stage&, Load, const TimeDomain&)> domain_finished = {};
};

/// Runs all stages and tests of a study and writes the results (docs/results.md) to a directory, which is made. Every
/// file appears whole or not at all; what is done when the run ends early stays. Throws InputError, NumericalError,
/// FileError or Interrupted.
StudyResult run_study(const Study& study, const std::filesystem::path& directory, int threads,
                      const StudyObserver& observer = {});

/// Packs the microstructures of a study alone and writes them.
StudyResult pack_study(const Study& study, const std::filesystem::path& directory, const StudyObserver& observer = {});

/// A stage with its microstructure, ready to be tested under a load.
DynamicTest make_test(const Study& study, const Stage& stage, const Microstructure& microstructure, Load load,
                      int threads);

/// "shear", "shear-xx-yy" or "bulk", as in decks and results.
std::string name_of(Load load);

}  // namespace breccia

#include "breccia/study/run.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/report/modulus_plot.hpp"

#include "named_errors.hpp"
#include "results.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

void make_directory(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw FileError(fmt::format("{}: cannot make this directory: {}", directory.string(), error.message()));
}

/// Removes what an earlier run left, so that no old number stands beside a new one.
void remove_old_results(const Study& study, const fs::path& directory) {
  const auto remove = [](const fs::path& file) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw FileError(fmt::format("{}: cannot remove this file: {}", file.string(), error.message()));
  };
  for (const auto* name : {"curves.csv", "study.json"}) remove(directory / name);
  for (const auto& stage : study.stages) {
    const auto stage_directory = directory / stage.name;
    if (!fs::is_directory(stage_directory)) continue;
    for (const auto* name : {"microstructure.csv", "microstructure.svg", "modulus.svg", "fields.vtkhdf"}) {
      remove(stage_directory / name);
    }
    for (const auto& entry : fs::directory_iterator(stage_directory)) {
      if (entry.path().filename().string().find("-displacement-dynamic-") != std::string::npos) remove(entry.path());
    }
  }
}

StageResult pack_stage(const Stage& stage, const fs::path& directory, const StudyObserver& observer) {
  const PackingWatch watch = [&](const PackingProgress& progress) {
    return !observer.packing || observer.packing(stage, progress);
  };
  StageResult result;
  result.name = stage.name;
  result.cells = stage.cells;
  result.microstructure = make_microstructure(stage, watch);
  result.warnings = result.microstructure.warnings;
  const auto discretisation = discretise(result.microstructure.microstructure, stage.cells);
  result.points = discretisation.points();
  result.point_fraction = discretisation.fractions(2)[1];
  make_directory(directory);
  write_microstructure(directory, stage, result.microstructure);
  if (observer.packed) observer.packed(result);
  return result;
}

TestResult run_test(const Study& study, const Stage& stage, const fs::path& directory, const DynamicTest& test,
                    const StudyObserver& observer) {
  std::size_t number = 0;
  DynamicObserver follow;
  follow.progress = [&](const DynamicProgress& progress) {
    if (observer.progress) observer.progress(stage, test.load, progress);
  };
  follow.finished = [&](const TimeDomain& domain) {
    write_history(directory, study, stage, test.load, ++number, domain);
    if (observer.domain_finished) observer.domain_finished(stage, test.load, domain);
  };
  const auto name = fmt::format("{} {}", stage.name, name_of(test.load));
  return {test.load, name_errors(name, [&] { return run_dynamic_test(test, follow); })};
}

/// Time domains that disagree where both should hold.
std::vector<std::string> warnings_of_overlaps(const Stage& stage, const TestResult& test) {
  constexpr double tolerance = 0.03;
  std::vector<std::string> warnings;
  for (const auto& [window, mismatch] : test.dynamic.overlaps) {
    if (mismatch <= tolerance) continue;
    warnings.push_back(
        fmt::format("{} {}: two time domains differ by {:.1f} % between {:.3g} and {:.3g} s; smaller density factors "
                    "or another ramp "
                    "bring them together",
                    stage.name, name_of(test.load), 100.0 * mismatch, window.begin, window.end));
  }
  return warnings;
}

}  // namespace

std::string name_of(Load load) {
  switch (load) {
    case Load::shear:
      return "shear";
    case Load::diagonal_shear:
      return "shear-xx-yy";
    case Load::bulk:
      return "bulk";
  }
  return {};
}

DynamicTest make_test(const Study& study, const Stage& stage, const Microstructure& microstructure, Load load,
                      int threads) {
  std::vector<Material> materials = {stage.matrix};
  if (stage.filler) materials.push_back(stage.filler->material);
  return {.discretisation = discretise(microstructure, stage.cells),
          .materials = std::move(materials),
          .load = load,
          .times = {study.tests.first_time, study.tests.last_time},
          .points_per_decade = study.tests.points_per_decade,
          .options = study.tests.dynamic,
          .threads = threads};
}

StudyResult pack_study(const Study& study, const fs::path& directory, const StudyObserver& observer) {
  make_directory(directory);
  remove_old_results(study, directory);
  StudyResult result;
  for (const auto& stage : study.stages) {
    result.stages.push_back(pack_stage(stage, directory / stage.name, observer));
    write_provenance(directory, study, result);
  }
  return result;
}

StudyResult run_study(const Study& study, const fs::path& directory, int threads, const StudyObserver& observer) {
  // Not after an hour of work.
  require_gnuplot();
  make_directory(directory);
  remove_old_results(study, directory);
  StudyResult result;
  for (const auto& stage : study.stages) {
    const auto stage_directory = directory / stage.name;
    result.stages.push_back(pack_stage(stage, stage_directory, observer));
    auto& done = result.stages.back();
    write_provenance(directory, study, result);
    for (const auto load : study.tests.loads) {
      const auto test = make_test(study, stage, done.microstructure.microstructure, load, threads);
      auto tested = run_test(study, stage, stage_directory, test, observer);
      // Fields are large: the first test's are written, and none is kept.
      if (done.tests.empty()) write_fields(stage_directory, stage, tested.dynamic.fields);
      tested.dynamic.fields = {};
      done.tests.push_back(std::move(tested));
      std::ranges::copy(warnings_of_overlaps(stage, done.tests.back()), std::back_inserter(done.warnings));
      write_curves(directory, result);
      write_provenance(directory, study, result);
    }
    write_plot(stage_directory, study, stage, done);
  }
  return result;
}

}  // namespace breccia

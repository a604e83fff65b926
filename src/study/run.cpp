#include "breccia/study/run.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/report/modulus_plot.hpp"
#include "breccia/study/memory.hpp"
#include "breccia/study/report.hpp"
#include "breccia/study/resume.hpp"
#include "breccia/study/stage_warnings.hpp"

#include "checkpoints.hpp"
#include "comparison.hpp"
#include "field_files.hpp"
#include "matrix_moduli.hpp"
#include "response_file.hpp"
#include "results.hpp"
#include "stage_extrapolation.hpp"
#include "stage_materials.hpp"
#include "stage_plot.hpp"
#include "stage_tests.hpp"
#include "sweep_results.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The names of all that a run of a study may have left, so that no old number stands beside a new one.
std::vector<std::string> old_results(const Study& study, const fs::path& directory) {
  auto names = curve_files();
  names.insert(names.end(), {"comparison.csv", "study.json", "report.html"});
  std::ranges::copy(sweep_files(), std::back_inserter(names));
  for (const auto& stage : study.stages) {
    for (const auto* name :
         {"microstructure.csv", "microstructure.svg", "modulus.svg", "bulk_modulus.svg", "response.h5"}) {
      names.push_back(stage.name + "/" + name);
    }
    if (!fs::is_directory(directory / stage.name)) continue;
    for (const auto& entry : fs::directory_iterator(directory / stage.name)) {
      const auto name = entry.path().filename().string();
      if (name.find("-dynamic-") != std::string::npos || is_of_fields(name) || is_checkpoint(name))
        names.push_back(fmt::format("{}/{}", stage.name, name));
    }
  }
  return names;
}

/// Removes what an earlier run has left, or of one that goes on only what it could not finish writing.
void make_way(const Study& study, const fs::path& directory, bool resume) {
  const auto names = old_results(study, directory);
  refuse_to_replace(directory, names, study.inputs);
  make_directory(directory);
  if (!resume) remove_files(directory, names);
  remove_partial_files(study, directory);
}

/// Takes a directory of results away again where a run has ended before any.
class UnlessEmpty {
 public:
  explicit UnlessEmpty(fs::path directory) : directory_(std::move(directory)) {}
  UnlessEmpty(const UnlessEmpty&) = delete;
  UnlessEmpty& operator=(const UnlessEmpty&) = delete;
  UnlessEmpty(UnlessEmpty&&) = delete;
  UnlessEmpty& operator=(UnlessEmpty&&) = delete;
  ~UnlessEmpty() {
    std::error_code is_not_empty;
    if (parallel::rank() != 0) return;
    // Alone it tells of no result.
    const auto entries = std::distance(fs::directory_iterator(directory_, is_not_empty), fs::directory_iterator());
    if (entries == 1) fs::remove(directory_ / "study.json", is_not_empty);
    fs::remove(directory_, is_not_empty);
  }

 private:
  fs::path directory_;
};

/// Results are written by the first of several processes.
template <class Write>
void write_once(const Write& write) {
  if (parallel::rank() == 0) write();
}

/// Leaves the deck in `study.json`, so that whoever goes on from the first packing can be told what differs.
void announce(const Study& study, const fs::path& directory) {
  write_once([&] {
    if (!fs::exists(directory / "study.json")) write_provenance(directory, study, {});
  });
}

StageResult describe(const Study& study, const Stage& stage, StageMicrostructure microstructure,
                     const fs::path& directory, const StudyObserver& observer) {
  StageResult result;
  result.name = stage.name;
  result.cells = stage.cells;
  result.microstructure = std::move(microstructure);
  result.warnings = warnings_on(study, stage, result.microstructure);
  const auto discretisation = discretise(result.microstructure.microstructure, stage.cells);
  result.points = discretisation.points();
  result.point_fraction = discretisation.fractions(2)[1];
  write_once([&] {
    make_directory(directory);
    write_microstructure(directory, stage, result.microstructure);
  });
  if (observer.packed) observer.packed(result);
  return result;
}

/// Packs a stage as far as no earlier run has, and writes it.
StageResult pack_stage(const Study& study, const Stage& stage, const fs::path& directory,
                       const Checkpoints& checkpoints, const StudyObserver& observer) {
  write_once([&] { make_directory(directory); });
  auto checkpoint = checkpoints.of_packing(stage);
  const auto follow = [&](const PackingProgress& progress) {
    if (observer.packing) observer.packing(stage, progress);
  };
  return describe(study, stage, make_microstructure(stage, follow, &checkpoint), directory, observer);
}

/// The tests of a stage, each written as soon as it is done.
class StageRun {
 public:
  StageRun(const Study& study, const Stage& stage, const fs::path& directory, int threads,
           const Checkpoints& checkpoints, const StudyObserver& observer, StudyResult& result)
      : study_(study),
        stage_(stage),
        directory_(directory),
        threads_(threads),
        checkpoints_(checkpoints),
        observer_(observer),
        result_(result),
        done_(result.stages.back()) {}

  void run() {
    for (const int cells : grids_of(stage_)) {
      const StageGrid grid = {
          &study_,  &stage_,      discretise(done_.microstructure.microstructure, cells), directory_ / stage_.name,
          threads_, &checkpoints_};
      for (const auto bound : study_.tests.bounds) {
        for (const auto method : study_.tests.methods) run(grid, boundary_of(bound), method);
      }
    }
    for (auto& test : extrapolate_tests(stage_, done_.tests)) keep(std::move(test));
    done_.comparisons = compare(study_, stage_, done_.tests);
    if (serves_as_matrix(study_, stage_)) {
      done_.materials = materials_from(study_, stage_, result_.stages, done_);
    }
    write_once([&] {
      write_comparisons(directory_, result_);
      write_provenance(directory_, study_, result_);
    });
    write_once([&] { write_plots(directory_ / stage_.name, study_, stage_, done_, references()); });
  }

 private:
  void run(const StageGrid& grid, Boundary boundary, Method method) {
    const auto& matrix = matrix_of(stage_, result_.stages, boundary, method);
    if (method == Method::quasistatic) {
      auto moduli = matrix_moduli(study_, stage_, result_.stages, boundary);
      for (auto& test : run_quasistatic(grid, matrix, std::move(moduli), boundary, observer_)) keep(std::move(test));
      write_once([&] { write_responses(grid.directory, study_, stage_, done_); });
      return;
    }
    for (const auto load : loads_of(study_, stage_)) keep(run_dynamic(grid, matrix, boundary, load, observer_));
  }

  /// The matrix, or of every boundary its own, and what was measured.
  [[nodiscard]] std::vector<ReferenceCurve> references() const {
    std::vector<ReferenceCurve> curves;
    const bool is_one = std::holds_alternative<Material>(stage_.matrix);
    for (const auto bound : study_.tests.bounds) {
      const auto boundary = boundary_of(bound);
      const auto& matrix = matrix_of(stage_, result_.stages, boundary, study_.tests.methods.front());
      auto& curve = curves.emplace_back();
      curve.label = is_one ? "matrix" : fmt::format("matrix, {}", bound_of(boundary));
      curve.boundary = boundary;
      for (const double time :
           logarithmic_times({study_.tests.first_time, study_.tests.last_time}, study_.tests.points_per_decade)) {
        curve.modulus.push_back({time, matrix.shear.at(time)});
      }
      if (is_one) break;
    }
    for (const auto& measurement : study_.measurements) {
      if (measurement.stage != stage_.name) continue;
      const auto known = measurement.known_within({study_.tests.first_time, study_.tests.last_time});
      if (!known) continue;
      auto& curve = curves.emplace_back(ReferenceCurve{"measured, " + measurement.label, {}, {}});
      for (const double time : logarithmic_times(*known, study_.tests.points_per_decade)) {
        curve.modulus.push_back({time, measurement.at(time)});
      }
    }
    return curves;
  }

  void keep(TestResult test) {
    done_.tests.push_back(std::move(test));
    const auto& kept = done_.tests.back();
    std::ranges::copy(warnings_of(stage_, kept), std::back_inserter(done_.warnings));
    write_once([&] {
      write_curves(directory_, result_);
      write_provenance(directory_, study_, result_);
    });
    if (observer_.finished) observer_.finished(stage_, kept);
  }

  const Study& study_;
  const Stage& stage_;
  const fs::path& directory_;
  int threads_;
  const Checkpoints& checkpoints_;
  const StudyObserver& observer_;
  StudyResult& result_;
  StageResult& done_;
};

}  // namespace

std::vector<int> grids_of(const Stage& stage) {
  auto grids = stage.coarser_cells;
  grids.push_back(stage.cells);
  return grids;
}

StudyResult pack_study(const Study& study, const fs::path& directory, const RunOptions& options,
                       const StudyObserver& observer) {
  if (options.resume) require_same_study(study, directory);
  write_once([&] { make_way(study, directory, options.resume); });
  const UnlessEmpty kept(directory);
  const Checkpoints checkpoints(study, directory, options, observer);
  announce(study, directory);
  // A run that is to go on has told more than packings.
  const bool is_told = holds_tests(directory);
  StudyResult result;
  for (const auto& stage : study.stages) {
    const UnlessEmpty kept_stage(directory / stage.name);
    result.stages.push_back(pack_stage(study, stage, directory / stage.name, checkpoints, observer));
    if (!is_told) write_once([&] { write_provenance(directory, study, result); });
  }
  return result;
}

StudyResult run_study(const Study& study, const fs::path& directory, const RunOptions& options,
                      const StudyObserver& observer) {
  const auto begin = std::chrono::steady_clock::now();
  // Not after an hour of work.
  require_gnuplot();
  if (options.resume) require_same_study(study, directory);
  if (!options.ignore_memory && parallel::is_alone()) require_memory(study, available_memory());
  write_once([&] { make_way(study, directory, options.resume); });
  const UnlessEmpty kept(directory);
  const Checkpoints checkpoints(study, directory, options, observer);
  announce(study, directory);
  StudyResult result;
  for (const auto& stage : study.stages) {
    const UnlessEmpty kept_stage(directory / stage.name);
    result.stages.push_back(pack_stage(study, stage, directory / stage.name, checkpoints, observer));
    write_once([&] { write_provenance(directory, study, result); });
    StageRun(study, stage, directory, options.threads, checkpoints, observer, result).run();
    write_once([&] { write_study_report(directory); });
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  write_once([&] {
    write_provenance(directory, study, result);
    write_study_report(directory);
    remove_checkpoints(study, directory);
  });
  return result;
}

}  // namespace breccia

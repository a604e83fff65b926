#include "breccia/study/run.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/directory_lock.hpp"
#include "breccia/io/empty_directory.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/study/memory.hpp"
#include "breccia/study/report.hpp"
#include "breccia/study/resume.hpp"

#include "checkpoints.hpp"
#include "comparison.hpp"
#include "field_files.hpp"
#include "history_file.hpp"
#include "matrix_moduli.hpp"
#include "packed_stage.hpp"
#include "response_file.hpp"
#include "result_directory.hpp"
#include "results.hpp"
#include "shared_stages.hpp"
#include "stage_extrapolation.hpp"
#include "stage_materials.hpp"
#include "stage_plot.hpp"
#include "stage_tests.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The number of entries of a directory; 0 where it cannot be read.
std::size_t count_entries(const fs::path& directory) noexcept {
  std::size_t count = 0;
  std::error_code error;
  for (fs::directory_iterator entry(directory, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    ++count;
  }
  return error ? 0 : count;
}

/// Removes a directory at the end of a run that has left no result in it.
class RemoveIfEmpty {
 public:
  explicit RemoveIfEmpty(fs::path directory) : directory_(std::move(directory)) {}
  RemoveIfEmpty(const RemoveIfEmpty&) = delete;
  RemoveIfEmpty& operator=(const RemoveIfEmpty&) = delete;
  RemoveIfEmpty(RemoveIfEmpty&&) = delete;
  RemoveIfEmpty& operator=(RemoveIfEmpty&&) = delete;
  ~RemoveIfEmpty() {
    if (parallel::rank() != 0) return;
    std::error_code is_missing;
    // A record alone tells of no result.
    if (count_entries(directory_) == 1) fs::remove(directory_ / "study.json", is_missing);
    remove_if_empty(directory_);
  }

 private:
  fs::path directory_;
};

/// Results are written by the first of several processes.
template <class Write>
void write_once(const Write& write) {
  if (parallel::rank() == 0) write();
}

/// The directory that the first process of a group chooses, for all of them, or the InputError that it throws.
template <class Choose>
fs::path chosen_by_first(const Choose& choose) {
  constexpr char is_chosen = '+', is_refused = '-', is_in_use = '!';
  std::string answer;
  if (parallel::rank() == 0) {
    try {
      answer = is_chosen + choose().string();
    } catch (const DirectoryInUse& error) {
      answer = is_in_use + std::string(error.what());
    } catch (const InputError& error) {
      answer = is_refused + std::string(error.what());
    }
  }
  answer = parallel::text_of_first(answer);
  if (answer.front() == is_in_use) throw DirectoryInUse(answer.substr(1));
  if (answer.front() == is_refused) throw InputError(answer.substr(1));
  return answer.substr(1);
}

/// Leaves the deck in `study.json`, so that whoever goes on from the first packing can be told what differs.
void announce(const Study& study, const fs::path& directory) {
  write_once([&] {
    if (!fs::exists(directory / "study.json")) write_provenance(directory, study, {});
  });
}

StageResult describe(const Study& study, const Stage& stage, StageMicrostructure microstructure,
                     const fs::path& directory, const StudyObserver& observer) {
  auto result = packed_stage(study, stage, std::move(microstructure));
  write_once([&] {
    make_directory(directory);
    write_microstructure(directory, stage, result.microstructure);
  });
  if (observer.packed) observer.packed(stage, result);
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
    if (serves_as_matrix(study_, stage_)) {
      done_.materials = materials_from(study_, stage_, result_.stages, done_);
    }
    finish();
  }

  /// The same with the tests that another task of a sweep has made of the same stage; their fields are in its files.
  void take_over(const fs::path& files) {
    write_once([&] {
      const auto directory = directory_ / stage_.name;
      make_directory(directory);
      write_microstructure(directory, stage_, done_.microstructure);
      write_responses(directory, study_, stage_, done_);
      write_histories(directory, study_, stage_, done_.tests);
      copy_fields(files, directory, done_.tests);
      write_curves(directory_, result_);
    });
    finish();
  }

 private:
  void finish() {
    done_.comparisons = compare(study_, stage_, done_.tests);
    write_once([&] {
      write_comparisons(directory_, result_);
      write_provenance(directory_, study_, result_);
    });
    write_once([&] { write_plots(directory_ / stage_.name, study_, stage_, done_, references()); });
  }

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
  std::optional<DirectoryLock> lock;
  const auto place = chosen_by_first([&] {
    lock.emplace(directory);
    return directory_to_pack_in(study, directory, options);
  });
  const RemoveIfEmpty kept(directory), kept_place(place);
  // A run has written more than packings already, and is to go on.
  const bool is_told = holds_tests(place);
  auto how = options;
  how.resume = options.resume || is_told;
  const Checkpoints checkpoints(study, place, how, observer);
  announce(study, place);
  StudyResult result;
  for (const auto& stage : study.stages) {
    const RemoveIfEmpty kept_stage(place / stage.name);
    result.stages.push_back(pack_stage(study, stage, place / stage.name, checkpoints, observer));
    if (!is_told) write_once([&] { write_provenance(place, study, result); });
  }
  write_once([&] { put_in_place(study, place, directory); });
  return result;
}

StudyResult run_study(const Study& study, const fs::path& directory, const RunOptions& options,
                      const StudyObserver& observer) {
  SharedStages nothing;
  return run_study(study, directory, options, observer, nothing);
}

StudyResult run_study(const Study& study, const fs::path& directory, const RunOptions& options,
                      const StudyObserver& observer, SharedStages& shared) {
  const auto begin = std::chrono::steady_clock::now();
  if (!options.ignore_memory && parallel::is_alone()) require_memory(study, available_memory());
  std::optional<DirectoryLock> lock;
  const auto place = chosen_by_first([&] {
    lock.emplace(directory);
    return directory_to_run_in(study, directory, options);
  });
  const RemoveIfEmpty kept(directory), kept_place(place);
  if (place != directory && observer.writes_beside) observer.writes_beside(place);
  const Checkpoints checkpoints(study, place, options, observer);
  announce(study, place);
  StudyResult result;
  for (std::size_t i = 0; i < study.stages.size(); ++i) {
    const auto& stage = study.stages[i];
    const auto hash = i < study.stage_hashes.size() ? study.stage_hashes[i] : std::string();
    const RemoveIfEmpty kept_stage(place / stage.name);
    if (const auto* known = shared.find(hash)) {
      if (known->failure) std::rethrow_exception(known->failure);
      result.stages.push_back(known->result);
      if (observer.taken_over) observer.taken_over(known->result, known->directory);
      StageRun(study, stage, place, options.threads, checkpoints, observer, result).take_over(known->directory);
    } else {
      shared.keep_failure_of(hash, [&] {
        result.stages.push_back(pack_stage(study, stage, place / stage.name, checkpoints, observer));
        write_once([&] { write_provenance(place, study, result); });
        StageRun(study, stage, place, options.threads, checkpoints, observer, result).run();
      });
      shared.keep(hash, {result.stages.back(), place / stage.name});
    }
    write_once([&] { write_study_report(place); });
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  write_once([&] {
    write_provenance(place, study, result);
    write_study_report(place);
    remove_checkpoints(study, place);
    put_in_place(study, place, directory);
  });
  shared.move_files(place, directory);
  return result;
}

}  // namespace breccia

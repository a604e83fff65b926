#include "breccia/campaign/run.hpp"

#include <chrono>
#include <exception>

#include "breccia/homogenisation/available_memory.hpp"
#include "breccia/homogenisation/memory.hpp"
#include "breccia/homogenisation/solve_stage.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/results/provenance.hpp"
#include "breccia/results/study_report.hpp"
#include "breccia/study/soundness.hpp"

#include "checkpoints.hpp"
#include "directory_sink.hpp"
#include "first_process.hpp"
#include "result_directory.hpp"
#include "result_place.hpp"
#include "shared_stages.hpp"

namespace breccia {
namespace {

/// Adds one stage to the result of a study: computed, or taken over from the task of a sweep that has it already.
void run_stage(const Study& study, const Stage& stage, const std::filesystem::path& place, const RunOptions& options,
               const RunObserver& observer, DirectorySink& sink, SharedStages& shared, StudyResult& result) {
  const auto& hashes = study.provenance.stage_hashes;
  const auto index = result.stages.size();
  const auto hash = index < hashes.size() ? hashes[index] : std::string();
  const RemoveIfEmpty kept_stage(place / stage.name);
  if (const auto* known = shared.find(hash)) {
    if (known->failure) std::rethrow_exception(known->failure);
    adopt_stage(study, stage, known->result, result);
    if (observer.taken_over) observer.taken_over(known->result, known->directory);
    sink.take_over(stage, known->directory, result);
    return;
  }
  shared.keep_failure_of(hash, [&] {
    pack_stage(study, stage, observer, sink, result);
    write_once([&] { write_provenance(place, study, result); });
    test_stage(study, stage, options.threads, observer, sink, result);
  });
  shared.keep(hash, {result.stages.back(), place / stage.name});
}

}  // namespace

StudyResult run_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                      const RunObserver& observer) {
  SharedStages nothing;
  return run_study(study, directory, options, observer, nothing);
}

StudyResult run_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                      const RunObserver& observer, SharedStages& shared) {
  const auto begin = std::chrono::steady_clock::now();
  require_sound(study);
  if (!options.ignore_memory && parallel::is_alone()) require_memory(study, available_memory());
  const ResultPlace results(study, directory, [&] { return directory_to_run_in(study, directory, options); });
  const auto& place = results.place();
  if (place != directory && observer.writes_beside) observer.writes_beside(place);
  const Checkpoints checkpoints(study, place, options, observer);
  DirectorySink sink(study, place, checkpoints);
  StudyResult result;
  for (const auto& stage : study.stages) {
    run_stage(study, stage, place, options, observer, sink, shared, result);
    write_once([&] { write_study_report(place); });
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  write_once([&] {
    write_provenance(place, study, result);
    write_study_report(place);
    remove_checkpoints(study, place);
  });
  results.commit();
  shared.move_files(place, directory);
  return result;
}

}  // namespace breccia

#include "campaign/directory_sink.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

#include "breccia/results/curves.hpp"

#include "io/text_file.hpp"
#include "page/study_report.hpp"
#include "parallel/common_failure.hpp"
#include "results/comparison_file.hpp"
#include "results/error_file.hpp"
#include "results/expansion_file.hpp"
#include "results/field_files.hpp"
#include "results/film_field_files.hpp"
#include "results/history_file.hpp"
#include "results/microstructure_files.hpp"
#include "results/provenance.hpp"
#include "results/response_file.hpp"
#include "results/stage_plot.hpp"
#include "results/stiffness_file.hpp"
#include "results/volume_field_files.hpp"

namespace breccia {

DirectorySink::DirectorySink(const ResultTransaction& results, const RunObserver& observer, SharedStages& shared)
    : study_(results.study()),
      directory_(results.place()),
      stage_hashes_(results.provenance().stage_hashes),
      observer_(observer),
      shared_(shared),
      checkpoints_(results, observer) {}

std::string DirectorySink::hash_of(const Stage& stage) const {
  const auto place = std::ranges::find(study_.stages, stage.name, &Stage::name) - study_.stages.begin();
  const auto index = static_cast<std::size_t>(place);
  return index < stage_hashes_.size() ? stage_hashes_[index] : std::string();
}

void DirectorySink::progress(const Progress& now) {
  if (observer_.progress) observer_.progress(now);
}

void DirectorySink::happened(const StudyEvent& event) {
  std::visit([this](const auto& one) { write(one); }, event);
}

std::optional<StageResult> DirectorySink::known_stage(const Stage& stage) {
  present_hash_ = hash_of(stage);
  const auto* const known = shared_.find(present_hash_);
  if (known == nullptr) return std::nullopt;
  if (known->failure) std::rethrow_exception(known->failure);
  return known->result;
}

std::unique_ptr<Checkpoint> DirectorySink::packing_checkpoint(const Stage& stage) {
  parallel::done_by_first([&] { make_directory(directory_ / stage.name); });
  return checkpoints_.of_packing(stage);
}

std::unique_ptr<Checkpoint> DirectorySink::test_checkpoint(const Stage& stage, const TestId& test) {
  return checkpoints_.of_test(stage, test);
}

bool DirectorySink::store_fields(const Stage& stage, const TestId& test, const TestFields& fields) {
  const auto store = [&](const auto& of_model) {
    return write_fields(directory_ / stage.name, study_, stage, test, of_model);
  };
  records_[stage.name].fields.push_back({test, std::visit(store, fields)});
  return true;
}

void DirectorySink::write(const StageAdopted& event) {
  const auto& stage = event.stage;
  const auto& known = *shared_.find(present_hash_);
  present_hash_.clear();
  const auto& done = event.result.stages.back();
  records_[stage.name] = known.record;
  if (known.record.answered_from.empty()) {
    observer_.tell(StageTakenOver{done, known.directory});
  } else {
    observer_.tell(StageFromResponses{done, known.record.answered_from});
  }
  parallel::done_by_first([&] {
    const auto directory = directory_ / stage.name;
    make_directory(directory);
    write_microstructure(directory, stage, done.microstructure);
    write_responses(directory, responses_of(study_, stage, done));
    write_histories(directory, study_, stage, done.tests);
    copy_fields(known.directory, directory, known.record);
    write_curves(directory_, event.result, FrequencyRows::of(study_.tests));
    write_finished_stage(stage, event.result);
  });
}

void DirectorySink::write(const StagePacked& event) {
  parallel::done_by_first([&] {
    write_microstructure(directory_ / event.stage.name, event.stage, event.result.stages.back().microstructure);
    write_record(event.result);
  });
  observer_.tell(event);
}

void DirectorySink::write(const DomainFinished& event) {
  parallel::done_by_first([&] {
    write_history(directory_ / event.stage.name, study_, event.stage, event.test, event.number, event.domain);
  });
  observer_.tell(event);
}

void DirectorySink::write(const FieldsStoredBefore& event) {
  records_[event.stage.name].fields.push_back({event.test, field_records(study_, event.test, event.times)});
}

void DirectorySink::write(const TestFinished& event) {
  parallel::done_by_first([&] {
    write_curves(directory_, event.result, FrequencyRows::of(study_.tests));
    write_record(event.result);
  });
  observer_.tell(event);
}

void DirectorySink::write(const AllLoadsFinished& event) {
  parallel::done_by_first([&] {
    write_responses(directory_ / event.stage.name, responses_of(study_, event.stage, event.result.stages.back()));
  });
}

void DirectorySink::write(const StageFinished& event) {
  parallel::done_by_first([&] { write_finished_stage(event.stage, event.result); });
  const auto& name = event.stage.name;
  shared_.keep(present_hash_,
               {.result = event.result.stages.back(), .record = records_[name], .directory = directory_ / name});
  present_hash_.clear();
  observer_.tell(event);
}

void DirectorySink::write(const StudyFinished& event) {
  parallel::done_by_first([&] { close_results(study_, directory_, write_record(event.result)); });
}

void DirectorySink::keep_failure(const std::exception_ptr& failure) {
  shared_.keep(present_hash_, {.failure = failure});
}

StudyDocument DirectorySink::write_record(const StudyResult& result) const {
  return write_provenance(directory_, study_, result, records_);
}

void DirectorySink::write_finished_stage(const Stage& stage, const StudyResult& result) const {
  // Errors are known now.
  write_curves(directory_, result, FrequencyRows::of(study_.tests));
  write_comparisons(directory_, result);
  write_expansions(directory_ / "thermal_expansion.csv", result);
  write_stiffness(directory_ / stiffness_file, result);
  const auto record = write_record(result);
  write_plots(directory_ / stage.name, study_, stage, result);
  write_study_report(directory_, record);
}

}  // namespace breccia

#include "directory_sink.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

#include "breccia/io/text_file.hpp"
#include "breccia/results/comparison_file.hpp"
#include "breccia/results/curves.hpp"
#include "breccia/results/field_files.hpp"
#include "breccia/results/film_field_files.hpp"
#include "breccia/results/history_file.hpp"
#include "breccia/results/microstructure_files.hpp"
#include "breccia/results/provenance.hpp"
#include "breccia/results/response_file.hpp"
#include "breccia/results/stage_plot.hpp"
#include "breccia/results/study_report.hpp"
#include "breccia/results/volume_field_files.hpp"
#include "breccia/study/identity.hpp"

#include "first_process.hpp"

namespace breccia {

DirectorySink::DirectorySink(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                             const RunObserver& observer, SharedStages& shared)
    : study_(study),
      directory_(directory),
      observer_(observer),
      shared_(shared),
      checkpoints_(study, directory, options, observer),
      stage_hashes_(provenance_of(study).stage_hashes) {}

std::string DirectorySink::hash_of(const Stage& stage) const {
  const auto place = std::ranges::find(study_.stages, stage.name, &Stage::name) - study_.stages.begin();
  const auto index = static_cast<std::size_t>(place);
  return index < stage_hashes_.size() ? stage_hashes_[index] : std::string();
}

std::optional<StageResult> DirectorySink::known_stage(const Stage& stage) {
  kept_if_not_empty_.emplace_back(directory_ / stage.name);
  present_hash_ = hash_of(stage);
  const auto* const known = shared_.find(present_hash_);
  if (known == nullptr) return std::nullopt;
  if (known->failure) std::rethrow_exception(known->failure);
  return known->result;
}

void DirectorySink::stage_adopted(const Stage& stage, const StudyResult& result) {
  const auto& known = *shared_.find(present_hash_);
  present_hash_.clear();
  const auto& done = result.stages.back();
  records_[stage.name] = known.record;
  if (known.record.answered_from.empty()) {
    if (observer_.taken_over) observer_.taken_over(done, known.directory);
  } else if (observer_.answered) {
    observer_.answered(done, known.record.answered_from);
  }
  write_once([&] {
    const auto directory = directory_ / stage.name;
    make_directory(directory);
    write_microstructure(directory, stage, done.microstructure);
    write_responses(directory, responses_of(study_, stage, done));
    write_histories(directory, study_, stage, done.tests);
    copy_fields(known.directory, directory, known.record);
    write_curves(directory_, result, FrequencyRows::of(study_.tests));
    write_finished_stage(stage, result);
  });
}

std::unique_ptr<Checkpoint> DirectorySink::packing_checkpoint(const Stage& stage) {
  write_once([&] { make_directory(directory_ / stage.name); });
  return checkpoints_.of_packing(stage);
}

std::unique_ptr<Checkpoint> DirectorySink::test_checkpoint(const Stage& stage, const TestId& test) {
  return checkpoints_.of_test(stage, test);
}

void DirectorySink::packed(const Stage& stage, const StudyResult& result) {
  write_once([&] {
    write_microstructure(directory_ / stage.name, stage, result.stages.back().microstructure);
    write_record(result);
  });
}

void DirectorySink::domain_finished(const Stage& stage, const TestId& test, std::size_t number,
                                    const TimeDomain& domain) {
  write_once([&] { write_history(directory_ / stage.name, study_, stage, test, number, domain); });
}

bool DirectorySink::store_fields(const Stage& stage, const TestId& test, const TestFields& fields) {
  const auto write = [&](const auto& of_model) {
    return write_fields(directory_ / stage.name, study_, stage, test, of_model);
  };
  records_[stage.name].fields.push_back({test, std::visit(write, fields)});
  return true;
}

void DirectorySink::fields_stored_before(const Stage& stage, const TestId& test, const std::vector<double>& times) {
  records_[stage.name].fields.push_back({test, field_records(study_, test, times)});
}

void DirectorySink::tested(const Stage& /*stage*/, const StudyResult& result) {
  write_once([&] {
    write_curves(directory_, result, FrequencyRows::of(study_.tests));
    write_record(result);
  });
}

void DirectorySink::all_loads_tested(const Stage& stage, const StudyResult& result) {
  write_once([&] { write_responses(directory_ / stage.name, responses_of(study_, stage, result.stages.back())); });
}

void DirectorySink::stage_finished(const Stage& stage, const StudyResult& result) {
  write_once([&] { write_finished_stage(stage, result); });
  shared_.keep(present_hash_,
               {.result = result.stages.back(), .record = records_[stage.name], .directory = directory_ / stage.name});
  present_hash_.clear();
}

void DirectorySink::finished(const StudyResult& result) {
  write_once([&] {
    write_record(result);
    write_study_report(directory_);
    remove_checkpoints(study_, directory_);
  });
}

void DirectorySink::keep_failure(const std::exception_ptr& failure) {
  shared_.keep(present_hash_, {.failure = failure});
}

void DirectorySink::write_record(const StudyResult& result) const {
  write_provenance(directory_, study_, result, records_);
}

void DirectorySink::write_finished_stage(const Stage& stage, const StudyResult& result) const {
  write_comparisons(directory_, result);
  write_record(result);
  for (const auto& note : write_plots(directory_ / stage.name, study_, stage, result)) {
    if (observer_.noted) observer_.noted(note);
  }
  write_study_report(directory_);
}

}  // namespace breccia

#include "campaign/checkpoints.hpp"

#include <system_error>

#include <fmt/format.h>

#include "campaign/result_transaction.hpp"
#include "io/text_file.hpp"
#include "page/study_report.hpp"
#include "results/checksums.hpp"
#include "results/result_files.hpp"

namespace breccia {

Checkpoints::Checkpoints(const ResultTransaction& results, const RunObserver& observer)
    : owner_{results.provenance().hash, BRECCIA_VERSION}, results_(results), observer_(observer) {}

std::unique_ptr<Checkpoint> Checkpoints::of_packing(const Stage& stage) const {
  return open(stage, "packing");
}

std::unique_ptr<Checkpoint> Checkpoints::of_test(const Stage& stage, const TestId& test) const {
  const auto name = fmt::format("{}-{}-{}", name_of(test.boundary), name_of(test.method), name_of(test.grid));
  return open(stage, test.method == Method::quasistatic ? name : fmt::format("{}-{}", name_of(test.load), name));
}

std::unique_ptr<Checkpoint> Checkpoints::open(const Stage& stage, const std::string& name) const {
  auto checkpoint = std::make_unique<Checkpoint>(results_.place() / stage.name / (name + ".checkpoint.h5"), owner_,
                                                 results_.options().checkpoints);
  if (!results_.resumes()) return checkpoint;
  for (const auto& problem : checkpoint->look_for_earlier()) {
    observer_.tell(Note{problem});
  }
  return checkpoint;
}

std::vector<std::string> checkpoint_files(const Study& study, const std::filesystem::path& directory) {
  std::vector<std::string> names;
  for (const auto& stage : study.stages) {
    std::error_code is_missing;
    for (const auto& entry : std::filesystem::directory_iterator(directory / stage.name, is_missing)) {
      const auto name = entry.path().filename().string();
      if (is_checkpoint_file(name)) names.push_back(fmt::format("{}/{}", stage.name, name));
    }
  }
  return names;
}

void close_results(const Study& study, const std::filesystem::path& directory, const StudyDocument& record) {
  std::vector<std::string> stages;
  for (const auto& stage : study.stages) stages.push_back(stage.name);
  write_study_report(directory, record);
  write_checksums(directory, stages);
  remove_files(directory, checkpoint_files(study, directory));
}

void remove_partial_files(const Study& study, const std::filesystem::path& directory) {
  remove_partial_study_files(directory);
  for (const auto& stage : study.stages) remove_partial_stage_files(directory / stage.name);
}

}  // namespace breccia

#include "campaign/pack.hpp"

#include <variant>

#include "breccia/study/soundness.hpp"

#include "campaign/checkpoints.hpp"
#include "campaign/result_directory.hpp"
#include "campaign/result_place.hpp"
#include "campaign/resume.hpp"
#include "homogenisation/run/solve_stage.hpp"
#include "io/text_file.hpp"
#include "parallel/common_failure.hpp"
#include "results/microstructure_files.hpp"
#include "results/provenance.hpp"
#include "study/identity.hpp"

namespace breccia {
namespace {

/// Writes packings to a directory, and the record of a study that has no tests there yet.
class PackingSink final : public StudySink {
 public:
  /// All arguments must outlive this object.
  PackingSink(const Study& study, const std::filesystem::path& directory, const Checkpoints& checkpoints,
              const RunObserver& observer)
      : study_(study),
        directory_(directory),
        checkpoints_(checkpoints),
        observer_(observer),
        has_tests_(holds_tests(directory)) {}

  void progress(const Progress& now) override {
    if (observer_.progress) observer_.progress(now);
  }

  std::unique_ptr<Checkpoint> packing_checkpoint(const Stage& stage) override {
    parallel::done_by_first([&] { make_directory(directory_ / stage.name); });
    return checkpoints_.of_packing(stage);
  }

  void happened(const StudyEvent& event) override {
    const auto& packed = std::get<StagePacked>(event);  // without tests there are no other events
    parallel::done_by_first([&] {
      write_microstructure(directory_ / packed.stage.name, packed.stage, packed.result.stages.back().microstructure);
      if (!has_tests_) write_provenance(directory_, study_, packed.result);
    });
    observer_.tell(packed);
  }

 private:
  const Study& study_;
  const std::filesystem::path& directory_;
  const Checkpoints& checkpoints_;
  const RunObserver& observer_;
  bool has_tests_;
};

}  // namespace

StudyResult pack_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                       const RunObserver& observer) {
  require_sound(study);
  const ResultPlace results(study, directory, [&] { return directory_to_pack_in(study, directory, options); });
  const auto& place = results.place();
  // An earlier run has written results of tests; the packing keeps them.
  auto how = options;
  how.resume = options.resume || holds_tests(place);
  const Checkpoints checkpoints(study, place, how, observer);
  PackingSink sink(study, place, checkpoints, observer);
  StudyResult result;
  result.study_hash = provenance_of(study).hash;
  for (const auto& stage : study.stages) {
    const RemoveIfEmpty kept_stage(place / stage.name);
    pack_stage(study, stage, sink, result);
  }
  results.commit();
  return result;
}

}  // namespace breccia

#include "campaign/pack.hpp"

#include <variant>

#include "breccia/study/soundness.hpp"

#include "campaign/checkpoints.hpp"
#include "campaign/result_transaction.hpp"
#include "homogenisation/run/solve_stage.hpp"
#include "io/text_file.hpp"
#include "parallel/common_failure.hpp"
#include "results/microstructure_files.hpp"
#include "results/provenance.hpp"

namespace breccia {
namespace {

/// Writes packings to a directory, and the record of a study that has no tests there yet.
class PackingSink final : public StudySink {
 public:
  /// Both must outlive this object.
  PackingSink(const ResultTransaction& results, const RunObserver& observer)
      : results_(results), observer_(observer), checkpoints_(results, observer) {}

  void progress(const Progress& now) override {
    if (observer_.progress) observer_.progress(now);
  }

  std::unique_ptr<Checkpoint> packing_checkpoint(const Stage& stage) override {
    parallel::done_by_first([&] { make_directory(results_.place() / stage.name); });
    return checkpoints_.of_packing(stage);
  }

  void happened(const StudyEvent& event) override {
    const auto& packed = std::get<StagePacked>(event);  // without tests there are no other events
    const auto& place = results_.place();
    parallel::done_by_first([&] {
      write_microstructure(place / packed.stage.name, packed.stage, packed.result.stages.back().microstructure);
      if (!results_.keeps_tests()) write_provenance(place, results_.study(), packed.result);
    });
    observer_.tell(packed);
  }

 private:
  const ResultTransaction& results_;
  const RunObserver& observer_;
  Checkpoints checkpoints_;
};

}  // namespace

StudyResult pack_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                       const RunObserver& observer) {
  ResultTransaction results(study, directory, options);
  return pack_study(results, observer);
}

StudyResult pack_study(ResultTransaction& results, const RunObserver& observer) {
  require_sound(results.study());
  results.begin_packing();
  PackingSink sink(results, observer);
  StudyResult result;
  result.study_hash = results.provenance().hash;
  for (const auto& stage : results.study().stages) pack_stage(results.study(), stage, sink, result);
  results.commit();
  return result;
}

}  // namespace breccia

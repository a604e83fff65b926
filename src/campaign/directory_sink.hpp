#pragma once

#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "breccia/campaign/run_observer.hpp"
#include "breccia/homogenisation/study_sink.hpp"

#include "campaign/checkpoints.hpp"
#include "campaign/result_transaction.hpp"
#include "campaign/shared_stages.hpp"
#include "results/stage_record.hpp"
#include "results/study_document.hpp"

namespace breccia {

/// Writes the results of a study to a directory as they are found, by the first of several processes. Results of stages
/// that other studies have, too, are taken over from those, or kept for them.
class DirectorySink final : public StudySink {
 public:
  /// Writes to the place of these results. All arguments must outlive this object.
  DirectorySink(const ResultTransaction& results, const RunObserver& observer, SharedStages& shared);

  void progress(const Progress& now) override;
  void happened(const StudyEvent& event) override;
  std::optional<StageResult> known_stage(const Stage& stage) override;
  std::unique_ptr<Checkpoint> packing_checkpoint(const Stage& stage) override;
  std::unique_ptr<Checkpoint> test_checkpoint(const Stage& stage, const TestId& test) override;
  bool store_fields(const Stage& stage, const TestId& test, const TestFields& fields) override;

  /// Keeps the reason why the present stage could not be computed, for other studies that have the stage.
  void keep_failure(const std::exception_ptr& failure);

 private:
  void write(const StageAdopted& event);
  void write(const StagePacked& event);
  void write(const DomainFinished& event);
  void write(const FieldsStoredBefore& event);
  void write(const TestFinished& event);
  void write(const AllLoadsFinished& event);
  void write(const StageFinished& event);
  void write(const StudyFinished& event);

  [[nodiscard]] std::string hash_of(const Stage& stage) const;
  // NOLINTNEXTLINE(modernize-use-nodiscard): it writes the record, too
  StudyDocument write_record(const StudyResult& result) const;
  void write_finished_stage(const Stage& stage, const StudyResult& result) const;

  const Study& study_;
  const std::filesystem::path& directory_;
  const std::vector<std::string>& stage_hashes_;  ///< empty for a study that is not as a deck gives it
  const RunObserver& observer_;
  SharedStages& shared_;
  Checkpoints checkpoints_;
  std::string present_hash_;  ///< hash of the stage that is being computed
  StageRecords records_;
};

}  // namespace breccia

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "breccia/campaign/run_observer.hpp"
#include "breccia/study/study.hpp"

#include "checkpoint/checkpoint.hpp"
#include "results/study_document.hpp"

namespace breccia {

class ResultTransaction;

/// The checkpoints of a study: one for every packing and test, in the directory of its stage.
class Checkpoints {
 public:
  /// Those in the place of the results. `observer` receives a note about each damaged file that was set aside. Both
  /// must outlive this object.
  Checkpoints(const ResultTransaction& results, const RunObserver& observer);

  [[nodiscard]] std::unique_ptr<Checkpoint> of_packing(const Stage& stage) const;
  /// The checkpoint of a test. All loads of a quasi-static test share one.
  [[nodiscard]] std::unique_ptr<Checkpoint> of_test(const Stage& stage, const TestId& test) const;

 private:
  [[nodiscard]] std::unique_ptr<Checkpoint> open(const Stage& stage, const std::string& name) const;

  StateOwner owner_;
  const ResultTransaction& results_;
  const RunObserver& observer_;
};

/// The checkpoints of a study, relative to its directory.
std::vector<std::string> checkpoint_files(const Study& study, const std::filesystem::path& directory);

/// Ends the work on results whose record, the content of `study.json`, says that they are complete: writes the page and
/// the checksums, and removes the checkpoints last, so that their presence shows that this function was interrupted.
void close_results(const Study& study, const std::filesystem::path& directory, const StudyDocument& record);

/// Removes the half-written files of a killed run.
void remove_partial_files(const Study& study, const std::filesystem::path& directory);

}  // namespace breccia

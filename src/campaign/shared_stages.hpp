#pragma once

#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "breccia/campaign/run.hpp"

#include "results/stage_record.hpp"

namespace breccia {

class ResultTransaction;
struct Sweep;

/// The results of stages that several tasks of a sweep have in common: the first task that needs a stage computes it,
/// and the other tasks reuse its result. Stages are identified by the hash of everything that their results depend on
/// (Provenance::stage_hashes).
class SharedStages {
 public:
  struct Entry {
    StageResult result = {};
    StageRecord record = {};
    std::filesystem::path directory = {};  ///< directory of its files
    std::exception_ptr failure = nullptr;  ///< error of a stage without result
  };

  /// An object for a single study, in which nothing is shared.
  SharedStages() = default;
  /// An object for the stages that at least two tasks have.
  explicit SharedStages(const Sweep& sweep);
  /// An object with the stages of one study, whose results were computed from the reduced responses of another task.
  /// They have no files.
  SharedStages(const Study& study, const std::vector<StageResult>& results, const std::string& task);

  /// The entry of a stage; nullptr if no task has computed it yet.
  [[nodiscard]] const Entry* find(const std::string& hash) const;
  /// Keeps a result, or the reason why there is none, for other tasks that have the stage.
  void keep(const std::string& hash, Entry entry);
  /// Updates the directories of the files of a task, which have been moved.
  void move_files(const std::filesystem::path& from, const std::filesystem::path& to);

 private:
  std::map<std::string, int> tasks_;  ///< number of tasks that have a stage, by its hash
  std::map<std::string, Entry> entries_;
};

/// Runs a study as the promised run_study() does, but in a directory that was opened before and with stages that are
/// shared with other tasks.
StudyResult run_study(ResultTransaction& results, const RunObserver& observer, SharedStages& shared);

}  // namespace breccia

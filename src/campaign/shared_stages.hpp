#pragma once

#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "breccia/campaign/run.hpp"
#include "breccia/results/stage_record.hpp"

namespace breccia {

struct Sweep;

/// What has become of stages that several tasks of a sweep have in common: the first task that comes to one computes
/// it, the others take it over. Stages are known by the hash of all that their results depend on
/// (Provenance::stage_hashes).
class SharedStages {
 public:
  struct Entry {
    StageResult result = {};
    StageRecord record = {};
    std::filesystem::path directory = {};  ///< where its files are
    std::exception_ptr failure = nullptr;  ///< why there is no result
  };

  /// Of a single study: nothing is shared.
  SharedStages() = default;
  /// Of the stages that at least two tasks have.
  explicit SharedStages(const Sweep& sweep);
  /// Of the stages of one study whose results the reduced responses of another task gave, without files.
  SharedStages(const Study& study, const std::vector<StageResult>& results, const std::string& task);

  /// What became of a stage; nullptr while no task has come to it.
  [[nodiscard]] const Entry* find(const std::string& hash) const;
  /// Keeps a result, or the reason why there is none, for other tasks that have the stage.
  void keep(const std::string& hash, Entry entry);
  /// The files of a task have been moved from one directory to another.
  void move_files(const std::filesystem::path& from, const std::filesystem::path& to);

 private:
  std::map<std::string, int> tasks_;  ///< how many have a stage, by its hash
  std::map<std::string, Entry> entries_;
};

/// Runs a study as run_study does, with stages that it shares with others.
StudyResult run_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                      const RunObserver& observer, SharedStages& shared);

}  // namespace breccia

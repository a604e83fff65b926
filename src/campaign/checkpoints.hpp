#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "breccia/campaign/run.hpp"

#include "checkpoint/checkpoint.hpp"

namespace breccia {

/// The checkpoints of a study: one for every packing and test, in the directory of its stage.
class Checkpoints {
 public:
  /// `observer` receives a note about each damaged file that was set aside. All arguments must outlive this object.
  Checkpoints(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
              const RunObserver& observer);

  [[nodiscard]] std::unique_ptr<Checkpoint> of_packing(const Stage& stage) const;
  /// The checkpoint of a test. All loads of a quasi-static test share one.
  [[nodiscard]] std::unique_ptr<Checkpoint> of_test(const Stage& stage, const TestId& test) const;

 private:
  [[nodiscard]] std::unique_ptr<Checkpoint> open(const Stage& stage, const std::string& name) const;

  StateOwner owner_;
  const std::filesystem::path* directory_;
  const RunOptions* options_;
  const RunObserver* observer_;
};

/// The checkpoints of a study, relative to its directory.
std::vector<std::string> checkpoint_files(const Study& study, const std::filesystem::path& directory);

/// Ends the work on results whose record says that they are complete: writes the page and the checksums, and removes
/// the checkpoints last, so that their presence shows that this function was interrupted.
void close_results(const Study& study, const std::filesystem::path& directory);

/// Removes the half-written files of a killed run.
void remove_partial_files(const Study& study, const std::filesystem::path& directory);

}  // namespace breccia

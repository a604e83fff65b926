#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "breccia/campaign/run.hpp"
#include "breccia/checkpoint/checkpoint.hpp"

namespace breccia {

/// The checkpoints of a study: of every packing and test one, in the directory of its stage.
class Checkpoints {
 public:
  /// `observer` is told of files that had to be left aside. All must live as long as this.
  Checkpoints(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
              const RunObserver& observer);

  [[nodiscard]] std::unique_ptr<Checkpoint> of_packing(const Stage& stage) const;
  /// Of a quasi-static test one for all loads.
  [[nodiscard]] std::unique_ptr<Checkpoint> of_test(const Stage& stage, const TestId& test) const;

 private:
  [[nodiscard]] std::unique_ptr<Checkpoint> open(const Stage& stage, const std::string& name) const;

  const Study* study_;
  const std::filesystem::path* directory_;
  const RunOptions* options_;
  const RunObserver* observer_;
};

/// Removes all checkpoints of a study, once it is done. Returns whether there were any.
bool remove_checkpoints(const Study& study, const std::filesystem::path& directory);

/// Removes what a killed run was writing.
void remove_partial_files(const Study& study, const std::filesystem::path& directory);

}  // namespace breccia

#pragma once

#include <string>
#include <vector>

#include "breccia/error.hpp"

namespace breccia {

/// The reason why results must not be written to a directory, and the remedy.
struct ResultConflict {
  enum class Remedy {
    none,               ///< the problem has the remedy in its text
    another_directory,  ///< write to another directory
    replacing_it,       ///< write to another directory, or replace the content
    replacing,          ///< write to another directory, or replace the results
    adding,             ///< write to another directory, replace the results or add to them
    not_resuming        ///< write to another directory, or replace the results by a run from the start
  };

  std::string problem;
  Remedy remedy = Remedy::another_directory;
  std::string free_directory = {};  ///< another directory to suggest
};

/// Error: a directory for results contains other files. The message has a line for each conflict, with its remedy in
/// the terms of the library.
class ConflictingResults : public InputError {
 public:
  explicit ConflictingResults(std::vector<ResultConflict> conflicts);
  [[nodiscard]] const std::vector<ResultConflict>& conflicts() const noexcept { return conflicts_; }

 private:
  std::vector<ResultConflict> conflicts_;
};

}  // namespace breccia

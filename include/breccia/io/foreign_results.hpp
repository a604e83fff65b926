#pragma once

#include <string>
#include <vector>

#include "breccia/error.hpp"

namespace breccia {

/// The reason why results must not be written to a directory, and what helps.
struct Objection {
  enum class Remedy {
    none,               ///< the problem says what helps
    another_directory,  ///< to write to another directory
    replacing_it,       ///< this, or to replace what is there
    replacing,          ///< this, or to replace the results that are there
    adding,             ///< this, to replace the results or to add to them
    not_resuming        ///< this, or to replace the results by a run from the start
  };

  std::string problem;
  Remedy remedy = Remedy::another_directory;
  std::string free_directory = {};  ///< another directory to suggest
};

/// A directory that results are to be written to holds something else. The message has a line for each objection, with
/// what helps in the words of the library.
class ForeignResults : public InputError {
 public:
  explicit ForeignResults(std::vector<Objection> objections);
  [[nodiscard]] const std::vector<Objection>& objections() const noexcept { return objections_; }

 private:
  std::vector<Objection> objections_;
};

}  // namespace breccia

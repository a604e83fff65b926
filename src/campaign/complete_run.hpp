#pragma once

#include <optional>
#include <string>
#include <vector>

namespace breccia {

/// A run that has left complete results of a study.
struct CompleteRun {
  std::optional<double> seconds = {};  ///< wall time; nothing unless the results are complete and can be taken
  std::string note = {};               ///< note for the user on files that are missing or have changed
};

/// Converts runs into a text, which is sent from one process to others, and back.
std::string text_of(const std::vector<CompleteRun>& runs);
std::vector<CompleteRun> complete_runs_in(const std::string& text);

}  // namespace breccia

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studio/folder.hpp"

namespace breccia::studio {

/// The results of a run or a sweep, as far as a list of them shows it.
struct ListedResult {
  std::string path = {};  ///< directory, relative to the folder: "results/asphalt"
  std::string title = {};
  std::string deck = {};       ///< name of the deck
  std::string deck_text = {};  ///< the deck as it was
  std::string date = {};       ///< ISO 8601, UTC; empty where it is not recorded
  bool has_overrides = false;  ///< whether values of the deck were replaced for the run
  bool is_complete = false;
  bool is_sweep = false;
  std::optional<double> seconds = {};  ///< wall time [s]
  bool has_page = false;
};

/// The results in the subdirectories of `results` of a folder, the latest first.
std::vector<ListedResult> results_in(const Folder& folder);

/// The directory, relative to the folder, for new results: the first of "results/a", "results/a-2", ... that does not
/// exist. `name` is that of the deck, or more, and without `.toml`.
std::string new_directory_for(const Folder& folder, const std::string& name);

/// The directory for a run of a deck with this text: that of its earlier results, which go on there, or a new one.
std::string directory_for(const Folder& folder, const std::string& name, const std::string& deck_text);

}  // namespace breccia::studio

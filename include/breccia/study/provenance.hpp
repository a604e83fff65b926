#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace breccia {

/// The origin of a study: its deck. Result files contain it, so that they can be distinguished from the results of
/// other studies. For a study that was composed in memory it is empty.
struct Provenance {
  std::filesystem::path deck;
  std::string deck_text;
  std::vector<std::filesystem::path> inputs;  ///< the deck, and the data files that it names
  std::vector<std::string> overrides;         ///< `key.path=value`
  std::string hash;                           ///< of the deck's content, overrides included, and of the data files
  /// One hash for each stage, of everything that its results depend on: the deck up to this stage without title and
  /// measurements, the data files, and the loads of the stage.
  std::vector<std::string> stage_hashes;
};

}  // namespace breccia

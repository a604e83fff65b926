#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace breccia {

/// Where a study comes from: the deck that says it. Results on the disk carry it, so that they can be told from those
/// of other studies. A study that is put together in memory has none.
struct Provenance {
  std::filesystem::path deck;
  std::string deck_text;
  std::vector<std::filesystem::path> inputs;  ///< the deck, and the data files that it names
  std::vector<std::string> overrides;         ///< `key.path=value`
  std::string hash;                           ///< of what the deck says, overrides included, and of the data files
  /// The hash of each stage: of everything that its results may depend on. That is the deck up to this stage, but for
  /// title and measurements, the data files, and the loads that the stage is tested under.
  std::vector<std::string> stage_hashes;
};

}  // namespace breccia

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace breccia {

/// Where a study comes from: the deck that says it. A study that is put together in memory has none. Results on the
/// disk carry the provenance that the study has when it is run (provenance_of in study/identity.hpp), so that they can
/// be told from those of other studies.
struct Provenance {
  std::filesystem::path deck;
  std::string deck_text;
  std::vector<std::filesystem::path> inputs;  ///< the deck, and the data files that it names
  std::vector<std::string> overrides;         ///< `key.path=value`
  std::string hash;                           ///< of what the deck says, overrides included, and of the data files
  /// The hash of each stage: of everything that its results may depend on. That is the deck up to this stage, but for
  /// title and measurements, the data files, and the loads that the stage is tested under.
  std::vector<std::string> stage_hashes;
  std::string content;  ///< content_of the study as the deck gave it: the hashes hold for no other content
};

}  // namespace breccia

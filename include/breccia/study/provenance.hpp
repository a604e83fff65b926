#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace breccia {

/// A data file and the hash of its content.
struct FileHash {
  std::string name;  ///< relative to the deck
  std::string hash;

  friend bool operator==(const FileHash&, const FileHash&) = default;
};

/// Where a study comes from: the deck that says it. A study that is put together in memory has none. Results on the
/// disk carry the provenance that the study has when it is run (provenance_of in study/identity.hpp), so that they can
/// be told from those of other studies.
struct Provenance {
  std::filesystem::path deck;
  std::string deck_text;
  std::vector<std::filesystem::path> inputs;  ///< the deck, and the data files that it names
  std::vector<std::string> overrides;         ///< `key.path=value`
  std::string hash;                           ///< of the deck's content, overrides included, and of the data files
  std::string deck_content_hash = {};         ///< of the deck's content, overrides included, without the data files
  std::vector<FileHash> file_hashes = {};     ///< of the data files
  /// One hash for each stage, of everything that its results depend on: the deck up to this stage without title and
  /// measurements, the data files, and the loads of the stage.
  std::vector<std::string> stage_hashes;
  std::map<std::string, std::vector<std::string>> warnings = {};  ///< about the deck, by the names of its stages
  std::string content;  ///< content_of the study as the deck gave it: the hashes hold for no other content
};

}  // namespace breccia

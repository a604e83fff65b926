#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace breccia {

/// A data file and the hash of its content.
struct FileHash {
  std::string name;  ///< path of the file, relative to the deck
  std::string hash;

  friend bool operator==(const FileHash&, const FileHash&) = default;
};

/// The origin of a study: the deck that describes it. A study that is put together in memory has no deck. Results on
/// the disk carry the provenance that the study has when it is run (provenance_of in study/identity.hpp), so that they
/// can be distinguished from those of other studies.
struct Provenance {
  std::filesystem::path deck;
  std::string deck_text;
  std::vector<std::filesystem::path> inputs;  ///< the deck, and the data files that it names
  std::vector<std::string> overrides;         ///< overrides, `key.path=value`
  std::string hash;                           ///< hash of the deck's content, overrides included, and of the data files
  std::string deck_content_hash = {};      ///< hash of the deck's content, overrides included, without the data files
  std::vector<FileHash> file_hashes = {};  ///< hashes of the data files
  /// One hash for each stage, of everything that its results depend on: the deck up to this stage without title and
  /// measurements, the data files, and the loads of the stage.
  std::vector<std::string> stage_hashes;
  /// Warnings about the deck, by the names of its stages.
  std::map<std::string, std::vector<std::string>> warnings = {};
  std::string content;  ///< content_of() the study as read from the deck; the hashes hold for this content alone
};

}  // namespace breccia

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// The content of `study.json` in a directory, the record of the study whose results are there.
struct StudyRecord {
  bool is_ours = false;      ///< whether the file exists and was written by Breccia
  bool is_complete = false;  ///< whether all results were computed and written
  bool has_tests = false;    ///< whether at least one test is finished, or may be in a record of another version
  std::string hash, version;
  std::string text_hash;              ///< hash of the file
  std::string deck_content_hash;      ///< hash of the content of the deck alone
  std::vector<FileHash> file_hashes;  ///< hashes of the data files
  std::string deck_text;
  std::vector<std::string> overrides;
  std::vector<std::string> stages;         ///< names of all stages; invalid directory names are left out
  std::vector<std::string> stages_packed;  ///< names of the stages that have a microstructure
  std::optional<double> wall_time;         ///< wall time of the complete run [s]

  /// Whether the results are of a study, by its provenance_of(), and were computed by this version of Breccia.
  [[nodiscard]] bool is_of(const Provenance& provenance) const;
  [[nodiscard]] bool is_of(const Study& study) const;
  [[nodiscard]] bool is_complete_run_of(const Provenance& provenance) const {
    return is_complete && wall_time && is_of(provenance);
  }
  [[nodiscard]] bool is_complete_run_of(const Study& study) const { return is_complete && wall_time && is_of(study); }
};

/// Reads `study.json` in a directory; an empty record if it is missing or was not written by Breccia. Throws FileError
/// when the file cannot be read.
StudyRecord read_study_record(const std::filesystem::path& directory);

/// Whether a file `study.json` or `sweep.json` exists and was written by Breccia. Throws FileError when it cannot be
/// read.
bool is_record_of_breccia(const std::filesystem::path& file);

/// The difference between the study of a record and another one, in words: "deck.toml: line 7 was `a`, is `b`", or "the
/// data file sizes.csv differs" where the content of the deck has not changed.
std::string difference(const StudyRecord& before, const Study& now);

}  // namespace breccia

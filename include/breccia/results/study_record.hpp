#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// What `study.json` in a directory says of the study that left its results there.
struct StudyRecord {
  bool is_ours = false;      ///< is there such a file, and did Breccia write it?
  bool is_complete = false;  ///< is everything done and written?
  bool has_tests = false;    ///< was a test finished?
  std::string hash, version;
  std::string deck_text;
  std::vector<std::string> overrides;
  std::vector<std::string> stages;         ///< names of all stages, as far as they are names of directories
  std::vector<std::string> stages_packed;  ///< names of those that have a microstructure
  std::optional<double> wall_time;         ///< of the complete run [s]

  /// Are the results those of this study, by this version of Breccia?
  [[nodiscard]] bool is_of(const Study& study) const;
  [[nodiscard]] bool is_complete_run_of(const Study& study) const { return is_complete && wall_time && is_of(study); }
};

/// Throws FileError when the file cannot be read.
StudyRecord read_study_record(const std::filesystem::path& directory);

/// Is there such a file, and did Breccia write it: `study.json`, or `sweep.json`? Throws FileError when it cannot be
/// read.
bool is_record_of_breccia(const std::filesystem::path& file);

/// In what a study differs from the one that left a record: "deck.toml: line 7 was `a`, is `b`".
std::string difference(const StudyRecord& before, const Study& now);

}  // namespace breccia

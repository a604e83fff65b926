#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/study/study.hpp"

#include "io/replacement.hpp"
#include "results/study_record.hpp"

namespace breccia {

/// The files and records that Breccia has left in the directory of a study's results and in its `unfinished`. A
/// replacement that was interrupted counts as complete, since it is completed once there are no conflicts.
struct EarlierResults {
  /// An object for a directory that is not read yet. The study, which is to be run there, must outlive the object.
  EarlierResults(const Study& study, std::filesystem::path directory);

  /// Reads the directory, which may be missing, and each record in it once. Changes nothing. Throws FileError.
  void read();

  [[nodiscard]] bool are_of_the_study() const { return results.is_of(provenance); }
  [[nodiscard]] bool are_complete() const { return results.is_complete_run_of(provenance); }
  [[nodiscard]] std::filesystem::path unfinished_place() const { return directory / unfinished_directory; }
  /// Whether a file in `unfinished` (a relative name) has a name that Breccia writes there. The name is decisive since
  /// the record may be missing: a run that was killed while it cleared the directory may have left any of the files.
  [[nodiscard]] bool has_left_unfinished(const std::string& name) const;

  const Study* study;
  Provenance provenance;  ///< provenance of the study
  std::filesystem::path directory;
  StudyRecord results = {}, unfinished = {};
  std::filesystem::path record = {};        ///< the file of the results' record
  std::vector<std::string> own_files = {};  ///< files that Breccia has written, relative to the directory
  /// Hashes of all records of a study or a sweep in the directory and in its `unfinished`, by which a sweep recognises
  /// them (RunOptions::replaceable).
  std::vector<std::string> hashes = {};
  std::string sweep_hash = {};         ///< hash of the record of a sweep; empty where there is none
  bool holds_sweep = false;            ///< whether a sweep's results are there
  bool has_lost_record = false;        ///< whether the files are complete results whose record is missing or damaged
  bool has_unfinished_record = false;  ///< whether `unfinished` has a record of a study
  bool are_beside = false;  ///< whether the results are complete in `unfinished`, and not yet moved from there
};

/// The names that the results of a study have, and those of a sweep that they replace.
ResultNames names_of_results();

}  // namespace breccia

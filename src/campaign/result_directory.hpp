#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/campaign/run.hpp"

#include "io/conflicting_results.hpp"

namespace breccia {

/// The directory to which a run writes until its results are complete: the directory of the results, or its
/// subdirectory `unfinished` if earlier results are kept until then. Throws ConflictingResults with the
/// conflicts_with() it before any change; then completes an interrupted replacement. A run that starts anew also
/// removes the files of an earlier run that has finished nothing. The caller must hold the DirectoryLock.
std::filesystem::path directory_to_run_in(const Study& study, const std::filesystem::path& directory,
                                          const RunOptions& options);

/// As directory_to_run_in(), but for packing without tests, which never removes finished tests: it resumes if they are
/// of the same study, and throws ConflictingResults if they are of another study.
std::filesystem::path directory_to_pack_in(const Study& study, const std::filesystem::path& directory,
                                           const RunOptions& options);

/// Replaces earlier results by those of a run, unless the run has written to their directory. Throws FileError. The
/// caller must hold the DirectoryLock.
void put_in_place(const Study& study, const std::filesystem::path& written, const std::filesystem::path& directory);

/// Completes the replacement of earlier results by those of a killed run of the study. Throws FileError. The caller
/// must hold the DirectoryLock.
void finish_interrupted_replacement(const Study& study, const std::filesystem::path& directory);

/// Hashes of the records of all earlier results in a directory and in its `unfinished`, by which a sweep recognises
/// them (RunOptions::replaceable).
std::vector<std::string> hashes_of_records_in(const std::filesystem::path& directory);

/// The reasons why a run must neither resume the results in a directory nor replace them; none if it may. A replacement
/// that was interrupted counts as complete. Changes nothing.
std::vector<ResultConflict> conflicts_with(const Study& study, const std::filesystem::path& directory,
                                           const RunOptions& options);

}  // namespace breccia

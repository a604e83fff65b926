#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// Whether this is the name of a file that a study writes to the directory of a stage.
bool is_file_of_a_stage(std::string_view name);

/// Whether this is the name, relative to the directory of a study, of a file that the study writes there or to the
/// directory of a stage.
bool is_file_of_a_study(std::string_view name);

/// Remove the half-written files of a study, of one of its stages or of a sweep that killed processes have left in its
/// directory. Throw FileError.
void remove_partial_study_files(const std::filesystem::path& directory);
void remove_partial_stage_files(const std::filesystem::path& directory);
void remove_partial_sweep_files(const std::filesystem::path& directory);

/// The existing files of a directory that have names of result files of a study, and those of the given stages; all
/// names are relative to the directory.
std::vector<std::string> study_files_in(const std::filesystem::path& directory, const std::vector<std::string>& stages);

/// The existing files of a directory that have names of result files of a sweep, without those of its tasks.
std::vector<std::string> sweep_files_in(const std::filesystem::path& directory);

}  // namespace breccia

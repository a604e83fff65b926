#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// Is this the name of a file that a study writes to the directory of a stage?
bool is_file_of_a_stage(std::string_view name);

/// The files of a study and of a sweep that are in a directory, and those of the stages given, relative to it.
std::vector<std::string> result_files_in(const std::filesystem::path& directory,
                                         const std::vector<std::string>& stages);

}  // namespace breccia

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// Whether this is the name of a file that a study writes to the directory of a stage.
bool is_file_of_a_stage(std::string_view name);

/// The existing result files of a study or a sweep in a directory, and those of the given stages; all names are
/// relative to the directory.
std::vector<std::string> result_files_in(const std::filesystem::path& directory,
                                         const std::vector<std::string>& stages);

}  // namespace breccia

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// The comparisons in `comparison.csv` and `comparison_dynamic.csv` of a directory, by the names of the stages; nothing
/// where there are no such files. Throws FileError when a file is not as `breccia run` writes it.
std::map<std::string, std::vector<Comparison>> read_comparisons(const std::filesystem::path& directory);

}  // namespace breccia

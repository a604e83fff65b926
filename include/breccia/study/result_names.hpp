#pragma once

#include <string>
#include <vector>

namespace breccia {

/// Names of the files with curves that a study or a response writes to its directory.
std::vector<std::string> curve_files();

/// Names of the files that a study writes to its directory itself; those of stages are in directories of their own.
std::vector<std::string> files_of_a_study();

/// Names of the files that a sweep writes beside the directories of its tasks.
std::vector<std::string> files_of_a_sweep();

/// Names in a directory of results, in lower case, that no stage may have as its directory.
std::vector<std::string> reserved_names();

}  // namespace breccia

#pragma once

#include <string>
#include <vector>

namespace breccia {

/// Names of the files with curves that a study or a response writes to its directory.
std::vector<std::string> curve_files();

/// Names of the files with comparisons with measurements that a study or a response writes to its directory.
std::vector<std::string> comparison_files();

/// Names of the files that a study writes to its directory, without those in the directories of its stages.
std::vector<std::string> files_of_a_study();

/// Names of the files that a sweep writes to its directory, without those in the directories of its tasks.
std::vector<std::string> files_of_a_sweep();

/// Names, in lower case, that a stage must not have, since files in the directory of the results have them.
std::vector<std::string> reserved_names();

}  // namespace breccia

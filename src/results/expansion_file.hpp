#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Writes the thermal expansion of all stages to a file, `thermal_expansion.csv`; none where no stage has one. Throws
/// FileError.
void write_expansions(const std::filesystem::path& file, const StudyResult& result);

/// The thermal expansion in such a file, by the names of the stages; nothing where there is none. Throws FileError
/// where it is not as `breccia run` writes it.
std::map<std::string, std::vector<StageExpansion>> read_expansions(const std::filesystem::path& file);

}  // namespace breccia

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Name of the file with the whole stiffness of all stages.
inline constexpr const char* stiffness_file = "stiffness.csv";

/// Writes the whole stiffness of all stages to a file, with its isotropic part; none where no stage has one. Throws
/// FileError.
void write_stiffness(const std::filesystem::path& file, const StudyResult& result);

/// The stiffness in such a file, by the names of the stages; nothing where there is none. Throws FileError where it is
/// not as `breccia run` writes it.
std::map<std::string, std::vector<StageStiffness>> read_stiffness(const std::filesystem::path& file);

}  // namespace breccia

#pragma once

#include <filesystem>

#include "breccia/homogenisation/respond.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Writes `response.h5` of a stage: the reduced responses of its tests, if it has any. Throws FileError.
void write_responses(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                     const StageResult& result);

/// Reads such a file. Throws FileError when it cannot be read or is not one of these.
StoredResponses read_responses(const std::filesystem::path& file);

}  // namespace breccia

#pragma once

#include <filesystem>

#include "breccia/study/run.hpp"

namespace breccia {

/// Writes `response.h5` of a stage: the reduced responses of its tests, if it has any.
void write_responses(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                     const StageResult& result);

}  // namespace breccia

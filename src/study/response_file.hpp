#pragma once

#include <filesystem>
#include <vector>

#include "breccia/study/run.hpp"

namespace breccia {

/// Writes `response.h5` of a stage: the reduced responses of its tests, if it has any.
void write_responses(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                     const std::vector<TestResult>& tests);

}  // namespace breccia

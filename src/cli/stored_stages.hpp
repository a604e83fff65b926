#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/homogenisation/respond.hpp"
#include "breccia/results/stored_materials.hpp"

namespace breccia::cli {

// The reduced responses in the directory of a run. All functions throw InputError where there are none, or none of the
// stage that is asked for.

/// The responses of one stage; with an empty name those of all stages, in alphabetical order.
std::vector<StoredResponses> responses_of_stage(const std::filesystem::path& results, const std::string& stage);

/// The responses of a stage and of the stages that it builds on; with an empty name those of all stages.
std::vector<StoredResponses> responses_of_chain(const std::filesystem::path& results, const std::string& stage);

/// The materials of the study of these responses, from study.json. Throws InputError where that is of another study.
std::vector<StoredMaterial> materials_of_study(const std::filesystem::path& results,
                                               const std::vector<StoredResponses>& stored);

}  // namespace breccia::cli

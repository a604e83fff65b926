#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "breccia/campaign/sweep.hpp"

namespace breccia {

/// The first task of a sweep that differs from a later one in the temperatures of materials alone. Its reduced
/// responses answer for the later one, too. Nothing where there is none, or where the tests leave no such responses.
std::optional<std::size_t> task_that_answers(const Sweep& sweep, std::size_t task);

/// The stages of a study as the reduced responses of another give them, whose results are in a directory and which
/// differs in temperatures alone. They are packed anew, to the same bits, and have no fields. Throws InputError where
/// the materials leave the moduli that were sampled, and FileError.
std::vector<StageResult> answered_stages(const Study& study, const std::filesystem::path& directory);

}  // namespace breccia

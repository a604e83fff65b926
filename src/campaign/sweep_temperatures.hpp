#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "campaign/sweep.hpp"

namespace breccia {

/// The first task of a sweep that differs from a later one only in the temperatures of materials, so that its reduced
/// responses give the results of the later one. Nothing if there is none, or if the tests save no reduced responses.
std::optional<std::size_t> task_that_answers(const Sweep& sweep, std::size_t task);

/// The results of the stages of a study from the reduced responses of another one, which differs only in temperatures
/// and whose results are in a directory. The packings are computed again, with bitwise identical results; there are no
/// fields. Throws InputError if the materials leave the range of the sampled moduli, and FileError.
std::vector<StageResult> answered_stages(const Study& study, const std::filesystem::path& directory);

}  // namespace breccia

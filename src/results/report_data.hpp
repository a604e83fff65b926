#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include <nlohmann/json.hpp>

#include "breccia/results/page_data.hpp"

namespace breccia {

/// Reads the record of a run, with a `title`, and what is made of it. Throws FileError when the record, or what it
/// names, is not as this program writes it.
PageData read_page_data(const std::filesystem::path& record,
                        const std::function<nlohmann::ordered_json(nlohmann::ordered_json)>& data_of);

/// Numbers for a picture, with six digits, which take half the room.
std::vector<double> rounded(std::vector<double> numbers);

}  // namespace breccia

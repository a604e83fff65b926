#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace breccia {

/// Reads the record of a run, with a `title`, and writes `report.html` beside it: a page with the data that are made of
/// the record. Throws FileError when the record, or what it names, is not as this program writes it.
void write_page(const std::filesystem::path& directory, const std::string& record,
                const std::function<std::string(std::string_view title, std::string_view data)>& page,
                const std::function<nlohmann::ordered_json(nlohmann::ordered_json)>& data_of);

/// Numbers for a picture, with six digits, which take half the room.
std::vector<double> rounded(std::vector<double> numbers);

}  // namespace breccia

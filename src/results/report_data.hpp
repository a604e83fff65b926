#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace breccia {

/// What a page shows.
struct PageData {
  std::string title;
  std::string json;
};

/// Reads the record of a run, with a `title`, and what is made of it. Throws FileError when the record, or what it
/// names, is not as this program writes it.
PageData read_page_data(const std::filesystem::path& record,
                        const std::function<nlohmann::ordered_json(nlohmann::ordered_json)>& data_of);

/// The data of the study, and of the sweep, whose results are in a directory. Throw FileError likewise.
PageData study_page_data(const std::filesystem::path& directory);
PageData sweep_page_data(const std::filesystem::path& directory);

/// Numbers for a picture, with six digits, which take half the room.
std::vector<double> rounded(std::vector<double> numbers);

}  // namespace breccia

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace breccia {

/// The data of a page.
struct PageData {
  std::string title;
  std::string json;
};

/// Reads the record of a run, which has a `title`, and makes the data of its page by a function. Throws FileError when
/// the record or a file that it names does not have the format of this version.
PageData read_page_data(const std::filesystem::path& record,
                        const std::function<nlohmann::ordered_json(nlohmann::ordered_json)>& data_of);

/// The data of the study, or of the sweep, whose results are in a directory. Throw FileError likewise.
PageData study_page_data(const std::filesystem::path& directory);
PageData sweep_page_data(const std::filesystem::path& directory);

/// Numbers for a figure, rounded to six digits to halve their size.
std::vector<double> rounded(std::vector<double> numbers);

}  // namespace breccia

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "page/page_data.hpp"

namespace breccia {

/// The data of a page with its title.
struct TitledData {
  std::string title;
  nlohmann::ordered_json data;
};

/// The data of a page, made by a function from the results that a record names. Throws FileError when one of the files
/// does not have the format of this version.
PageData page_data(const std::filesystem::path& record, const std::function<TitledData()>& make);

/// Reads the record of a run, which has a `title`, and makes the data of its page by a function. Throws FileError when
/// the record or a file that it names does not have the format of this version.
PageData read_page_data(const std::filesystem::path& record,
                        const std::function<nlohmann::ordered_json(nlohmann::ordered_json)>& data_of);

/// Whether a file exists; false also for a name that no file can have.
bool is_there(const std::filesystem::path& file);

/// Numbers for a figure, rounded to six digits to halve their size.
std::vector<double> rounded(std::vector<double> numbers);

}  // namespace breccia

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace breccia {

/// The table of a CSV file for a page: an object with an array of numbers or texts for each column. Infinity, which
/// JSON does not have, is the text "inf". An empty object if the file does not exist. Throws InputError or FileError if
/// the file is damaged.
nlohmann::ordered_json table_for_page(const std::filesystem::path& file, const std::vector<std::string>& text_columns);

/// The columns of the tables of a study that hold text.
std::vector<std::string> text_columns_of_tests();

}  // namespace breccia

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace breccia {

/// The table of a CSV file for a page: an object with an array for each column, of numbers or of text. JSON knows no
/// infinity: it is the text "inf". An empty object where there is no such file. Throws InputError or FileError where
/// the file is damaged.
nlohmann::ordered_json table_for_page(const std::filesystem::path& file, const std::vector<std::string>& text_columns);

/// The columns of the tables of a study that hold text.
std::vector<std::string> text_columns_of_tests();

}  // namespace breccia

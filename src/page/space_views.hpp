#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "results/study_document.hpp"

namespace breccia {

/// The data for the rotatable views of a page, of the stages in three dimensions of a study whose results are in a
/// directory: `colours` (colours_of_fields) and, by stage, `microstructure` (microstructure_view) and `fields`
/// (field_view) by the names of their files. Null for a study of two dimensions. Throws FileError, and InputError when
/// a file is not as Breccia writes it.
nlohmann::ordered_json space_views(const std::filesystem::path& directory, const StudyDocument& study);

}  // namespace breccia

#pragma once

#include <filesystem>

#include "page/page_data.hpp"
#include "results/study_document.hpp"

namespace breccia {

/// The data for the page of the study whose results are in a directory, complete or not. Throws FileError when a file
/// cannot be read, is not as this program writes it, or belongs to another study.
PageData study_page_data(const std::filesystem::path& directory);

/// Writes the page of study_page_data(), `report.html`, to the directory. Throws FileError.
void write_study_report(const std::filesystem::path& directory);
/// Writes the page of the study whose `study.json` in the directory has this content. Throws as write_study_report()
/// without it.
void write_study_report(const std::filesystem::path& directory, const StudyDocument& study);

}  // namespace breccia

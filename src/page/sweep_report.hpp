#pragma once

#include <filesystem>

#include "page/page_data.hpp"
#include "results/sweep_result.hpp"

namespace breccia {

/// The data of the sweep whose results are in a directory, complete or not. Throws FileError when one of them cannot be
/// read or is not as this program writes it.
PageData sweep_page_data(const std::filesystem::path& directory);

/// Writes the page of these data, `report.html`, to the directory, beside `sweep.json`. Throws FileError.
void write_sweep_report(const std::filesystem::path& directory);

/// The same with curves that are in the memory.
void write_sweep_report(const std::filesystem::path& directory, const SweepResult& result);

}  // namespace breccia

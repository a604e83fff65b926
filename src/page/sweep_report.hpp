#pragma once

#include <filesystem>

#include "page/page_data.hpp"
#include "results/sweep_result.hpp"

namespace breccia {

/// The data for the page of the sweep whose results are in a directory, complete or not. Throws FileError when a file
/// cannot be read or is not as this program writes it.
PageData sweep_page_data(const std::filesystem::path& directory);

/// Writes the page of sweep_page_data(), `report.html`, to the directory, beside `sweep.json`. Throws FileError.
void write_sweep_report(const std::filesystem::path& directory);

/// As write_sweep_report() above, but with the curves of a result in memory.
void write_sweep_report(const std::filesystem::path& directory, const SweepResult& result);

}  // namespace breccia

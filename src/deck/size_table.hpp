#pragma once

#include <filesystem>

#include "breccia/study/filler.hpp"

namespace breccia {

/// Reads a CSV file with the columns diameter_m and cumulative_volume_fraction, in any order of its rows (table_of).
/// Throws InputError with the location of the mistake, and FileError when the file cannot be read.
TabulatedSizes read_size_table(const std::filesystem::path& path);

}  // namespace breccia

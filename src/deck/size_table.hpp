#pragma once

#include <filesystem>

#include "breccia/study/filler.hpp"

namespace breccia {

/// Reads a CSV file with the columns diameter_m (rising) and cumulative_volume_fraction (from 0 to 1). Throws
/// InputError with the location of the mistake, and FileError when the file cannot be read.
TabulatedSizes read_size_table(const std::filesystem::path& path);

}  // namespace breccia

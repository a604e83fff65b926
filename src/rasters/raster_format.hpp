#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace breccia {

/// The formats in which images are read.
enum class RasterFormat { png, tiff, npy, vti, hdf5 };

/// Number of bytes at the beginning of a file that determine its format.
inline constexpr std::size_t bytes_that_tell_format = 4096;

/// The format of a file that begins with these bytes. Throws InputError if the file has none of these formats.
RasterFormat raster_format(const std::filesystem::path& file, std::string_view beginning);

}  // namespace breccia

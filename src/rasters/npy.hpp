#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace breccia {

/// Writes labels atomically as a NumPy array of type uint16, indexed [y][x] or [z][y][x] with the top row first, so
/// that read_raster() returns them in the same order. `extents` and the order of `labels` are those of a Raster. Throws
/// InputError if the labels do not fill the extents, and FileError.
void write_npy(const std::filesystem::path& path, std::span<const std::size_t> extents,
               std::span<const std::uint16_t> labels);

}  // namespace breccia

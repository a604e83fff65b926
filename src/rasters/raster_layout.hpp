#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "breccia/rasters/raster.hpp"

namespace breccia {

/// Number of pixels. Throws InputError if there are none, or 2^29 and more.
std::size_t pixel_count(const std::filesystem::path& file, std::span<const std::size_t> extents);

/// Throws InputError if a compressed file of this size cannot contain this number of bytes at the best compression: a
/// damaged number must not make the program allocate all of the memory.
void require_plausible_size(const std::filesystem::path& file, std::size_t bytes, std::size_t file_size);

/// The extents along x, y and z of an array with this shape, whose last index runs fastest. Throws InputError if the
/// array has another number of dimensions than two or three, or the shape of a colour picture.
std::vector<std::size_t> extents_of_array(const std::filesystem::path& file, std::span<const std::size_t> shape);

/// A raster of values whose first row is the top one.
Raster raster_from_top(std::vector<std::size_t> extents, std::vector<std::int32_t> values);

/// A raster of values whose first row is the lowest one.
Raster raster_from_bottom(std::vector<std::size_t> extents, std::vector<std::int32_t> values);

}  // namespace breccia

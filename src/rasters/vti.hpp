#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace breccia {

/// A number for each pixel or voxel of an image, in the order of Raster::values.
struct VtiArray {
  std::string name;
  std::variant<std::span<const std::uint16_t>, std::span<const std::int32_t>> values;
};

/// Writes arrays atomically as cell data of a VTK ImageData file (.vti), compressed by zlib, which ParaView opens and
/// read_raster() reads. The first array is the active one. `extents` are those of a Raster, and `pixel` is the side of
/// a pixel [m]. Throws InputError if there is no array, or if one does not fill the extents, and FileError.
void write_vti(const std::filesystem::path& path, std::span<const std::size_t> extents, double pixel,
               std::span<const VtiArray> arrays);

}  // namespace breccia

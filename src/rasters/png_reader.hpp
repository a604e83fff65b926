#pragma once

#include <filesystem>
#include <string_view>

#include "breccia/rasters/raster.hpp"

namespace breccia {

/// Reads the bytes of a PNG file as read_raster() does.
Raster read_png(const std::filesystem::path& file, std::string_view bytes);

}  // namespace breccia

#pragma once

#include <filesystem>
#include <string_view>

#include "breccia/rasters/raster.hpp"

namespace breccia {

/// Reads the bytes of a TIFF file as read_raster() does.
Raster read_tiff(const std::filesystem::path& file, std::string_view bytes);

}  // namespace breccia

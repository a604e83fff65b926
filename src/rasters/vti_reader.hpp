#pragma once

#include <filesystem>
#include <string_view>

#include "breccia/rasters/raster.hpp"

namespace breccia {

/// Reads the bytes of a VTK ImageData file (.vti) as read_raster() does.
Raster read_vti(const std::filesystem::path& file, std::string_view bytes, std::string_view array);

}  // namespace breccia

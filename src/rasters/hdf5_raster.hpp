#pragma once

#include <filesystem>
#include <string>

#include "breccia/rasters/raster.hpp"

namespace breccia {

/// Reads a data set of an HDF5 file as read_raster() does.
Raster read_hdf5_raster(const std::filesystem::path& file, const std::string& array);

}  // namespace breccia

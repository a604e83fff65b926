#pragma once

#include <string_view>
#include <vector>

#include "breccia/rasters/raster.hpp"

namespace breccia::test {

/// The PNGs within an SVG, in its order: the numbers of their colours, from the lowest row up.
std::vector<Raster> embedded_pictures(std::string_view svg);

}  // namespace breccia::test

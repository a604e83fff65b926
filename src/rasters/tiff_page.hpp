#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "breccia/rasters/raster.hpp"

#include "rasters/raster_elements.hpp"
#include "rasters/tiff_file.hpp"

namespace breccia {

/// The storage of the pixels in the present page of a TIFF file.
struct TiffPage {
  std::size_t width = 0, height = 0;
  unsigned bits = 0;            ///< bits of a sample
  std::size_t channels = 0;     ///< samples of a pixel
  ElementType type;             ///< type of samples of whole bytes
  bool is_from_the_top = true;  ///< the first row is the top one
  Shades shades = Shades::rising;
};

/// Throws InputError for a page that does not hold labels: colours that are not in a palette, parts of a pixel,
/// rotated.
TiffPage page_layout(const TiffFile& tiff);

/// Appends the values of the present page, row by row as in the file. Throws InputError for a damaged page.
void append_page(std::vector<std::int32_t>& values, const TiffFile& tiff, const TiffPage& page);

}  // namespace breccia

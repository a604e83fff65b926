#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace breccia {

/// ImageJ's entries in the ImageDescription of a TIFF file: lines such as `ImageJ=1.54f`, `images=12`, `unit=micron`.
struct ImagejDescription {
  std::size_t images = 1;         ///< number of images in the whole file
  std::size_t channels = 1;       ///< number of channels of each point
  std::size_t frames = 1;         ///< number of points in time
  std::optional<double> unit;     ///< unit of the resolution [m]; nothing for pixels and unknown units
  std::optional<double> spacing;  ///< distance of layers, in this unit
};

/// Reads the entries; returns nothing if the text is not from ImageJ.
std::optional<ImagejDescription> read_imagej_description(std::string_view text);

}  // namespace breccia

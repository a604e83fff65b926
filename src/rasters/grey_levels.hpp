#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace breccia {

/// The samples of a picture's pixels: grey and opacity (2 channels), red, green and blue (3), or red, green, blue and
/// opacity (4).
struct PixelSamples {
  std::size_t channels;
  std::uint16_t most;  ///< largest sample, that of an opaque pixel
  std::vector<std::uint16_t> samples;
};

/// The grey level of each pixel. Throws InputError, with the most frequent colours, if a pixel is not grey, and if one
/// is not opaque.
std::vector<std::int32_t> grey_levels(const std::filesystem::path& file, const PixelSamples& picture);

}  // namespace breccia

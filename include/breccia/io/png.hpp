#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace breccia {

/// A colour of the sRGB space.
struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;

  friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// A PNG file: rows of pixels from the top, each the index of a colour of the palette, which has at most 256. Throws
/// InputError when the pixels do not fill rows or have no colour, and FileError when the picture cannot be encoded.
std::string encode_png(std::size_t width, std::span<const std::uint8_t> pixels, std::span<const Rgb> palette);

}  // namespace breccia

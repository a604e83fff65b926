#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace breccia {

/// A colour in the sRGB colour space.
struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;

  friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// The bytes of a PNG file. `pixels` has the rows of the picture from the top; each pixel is an index into the palette,
/// which has at most 256 colours. Throws InputError when the last row is not full or a pixel is not an index of the
/// palette, and FileError when the picture cannot be encoded.
std::string encode_png(std::size_t width, std::span<const std::uint8_t> pixels, std::span<const Rgb> palette);

}  // namespace breccia

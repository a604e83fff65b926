#include "report/embedded_png.hpp"

#include <charconv>

#include "rasters/base64.hpp"

namespace breccia {

Rgb parsed_colour(std::string_view text) {
  const auto part = [text](std::size_t place) {
    std::uint8_t value = 0;
    const auto digits = text.substr(place, 2);
    std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    return value;
  };
  return {part(1), part(3), part(5)};
}

std::string embedded_png(std::size_t width, std::span<const std::uint8_t> pixels, std::span<const Rgb> palette) {
  return "data:image/png;base64," + encode_base64(encode_png(width, pixels, palette));
}

}  // namespace breccia

#include "report/embedded_png.hpp"

#include "rasters/base64.hpp"

namespace breccia {

std::string embedded_png(std::size_t width, std::span<const std::uint8_t> pixels, std::span<const Rgb> palette) {
  return "data:image/png;base64," + encode_base64(encode_png(width, pixels, palette));
}

}  // namespace breccia

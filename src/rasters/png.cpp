#include "rasters/png.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <png.h>

#include "breccia/error.hpp"

namespace breccia {

std::string encode_png(std::size_t width, std::span<const std::uint8_t> pixels, std::span<const Rgb> palette) {
  static_assert(sizeof(Rgb) == 3, "libpng takes a palette as bytes");
  if (width == 0 || pixels.empty() || pixels.size() % width != 0) {
    throw InputError(fmt::format("png: {} pixels do not fill rows of {}", pixels.size(), width));
  }
  if (palette.size() > 256 || std::ranges::max(pixels) >= palette.size()) {
    throw InputError(fmt::format("png: a pixel has colour {} of {}", std::ranges::max(pixels), palette.size()));
  }
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.format = PNG_FORMAT_RGB_COLORMAP;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(pixels.size() / width);
  image.colormap_entries = static_cast<png_uint_32>(palette.size());
  constexpr int as_it_is = 0, packed_rows = 0;
  const auto encode = [&](void* memory, png_alloc_size_t& size) {
    if (png_image_write_to_memory(&image, memory, &size, as_it_is, pixels.data(), packed_rows, palette.data()) == 0) {
      throw FileError(fmt::format("png: {}", image.message));
    }
  };
  png_alloc_size_t size = 0;
  encode(nullptr, size);
  std::string file(size, '\0');
  encode(file.data(), size);
  file.resize(size);
  return file;
}

}  // namespace breccia

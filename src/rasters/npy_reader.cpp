#include "rasters/npy_reader.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"
#include "rasters/npy_header.hpp"
#include "rasters/raster_elements.hpp"
#include "rasters/raster_layout.hpp"

namespace breccia {

namespace {

/// The element type of a type of NumPy such as "<u2".
ElementType element_type(const std::filesystem::path& file, std::string_view type) {
  using enum ElementType::Kind;
  struct Known {
    std::string_view name;
    ElementType::Kind kind;
    std::size_t bytes;
  };
  static constexpr std::array<Known, 11> known = {{{"b1", unsigned_integer, 1},
                                                   {"u1", unsigned_integer, 1},
                                                   {"u2", unsigned_integer, 2},
                                                   {"u4", unsigned_integer, 4},
                                                   {"u8", unsigned_integer, 8},
                                                   {"i1", signed_integer, 1},
                                                   {"i2", signed_integer, 2},
                                                   {"i4", signed_integer, 4},
                                                   {"i8", signed_integer, 8},
                                                   {"f4", floating_point, 4},
                                                   {"f8", floating_point, 8}}};
  const auto order = type.substr(0, 1);
  const auto found = std::ranges::find(known, type.substr(order.size()), &Known::name);
  if (found == known.end() || std::string_view("<>|=").find(order) == std::string_view::npos) {
    throw InputError(fmt::format(
        "{}: an array of the NumPy type {}; expected booleans, integers, or floating-point numbers that are whole",
        file.string(), shown_value(type)));
  }
  const auto endian = order == ">" ? std::endian::big : order == "<" ? std::endian::little : std::endian::native;
  return {found->kind, found->bytes, endian};
}

/// The values of an array whose first index runs fastest in the order in which the last one does.
std::vector<std::int32_t> from_fortran_order(std::span<const std::size_t> shape,
                                             const std::vector<std::int32_t>& values) {
  const auto layers = shape.size() == 3 ? shape[0] : 1, height = shape[shape.size() - 2], width = shape.back();
  std::vector<std::int32_t> turned(values.size());
  for (std::size_t x = 0; x < width; ++x) {
    for (std::size_t y = 0; y < height; ++y) {
      for (std::size_t z = 0; z < layers; ++z) {
        turned[x + width * (y + height * z)] = values[z + layers * (y + height * x)];
      }
    }
  }
  return turned;
}

}  // namespace

Raster read_npy(const std::filesystem::path& file, std::string_view bytes) {
  const auto header = read_npy_header(file, bytes);
  const auto type = element_type(file, header.type);
  auto extents = extents_of_array(file, header.shape);
  const auto pixels = pixel_count(file, extents);
  bytes.remove_prefix(header.size);
  if (bytes.size() != pixels * type.bytes) {
    throw InputError(fmt::format("{}: {} bytes of numbers; expected {} for {} pixels of type {}", file.string(),
                                 bytes.size(), pixels * type.bytes, pixels, header.type));
  }
  std::vector<std::int32_t> values;
  values.reserve(pixels);
  append_elements(values, file, bytes, type);
  if (header.fortran_order) values = from_fortran_order(header.shape, values);
  return raster_from_top(std::move(extents), std::move(values));
}

}  // namespace breccia

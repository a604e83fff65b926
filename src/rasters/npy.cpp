#include "rasters/npy.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"

namespace breccia {

namespace {

/// Version 1.0 of the format: the numbers begin at a multiple of 64 bytes.
std::string npy_beginning(std::span<const std::size_t> extents) {
  constexpr std::size_t before_header = 10, alignment = 64;
  const std::vector<std::size_t> shape(extents.rbegin(), extents.rend());
  auto header = fmt::format("{{'descr': '<u2', 'fortran_order': False, 'shape': ({}), }}", fmt::join(shape, ", "));
  const auto unpadded = before_header + header.size() + 1;
  header.append((alignment - unpadded % alignment) % alignment, ' ');
  header += '\n';
  const auto low = static_cast<char>(header.size() % 256), high = static_cast<char>(header.size() / 256);
  return std::string("\x93NUMPY\x01", 7) + '\0' + low + high + header;
}

void append_little_endian(std::string& bytes, std::span<const std::uint16_t> labels) {
  for (const unsigned label : labels) {
    bytes += static_cast<char>(label & 0xffU);
    bytes += static_cast<char>(label >> 8U);
  }
}

}  // namespace

void write_npy(const std::filesystem::path& path, std::span<const std::size_t> extents,
               std::span<const std::uint16_t> labels) {
  const auto count = std::accumulate(extents.begin(), extents.end(), std::size_t{1}, std::multiplies<>());
  if ((extents.size() != 2 && extents.size() != 3) || count == 0 || count != labels.size()) {
    throw InputError(fmt::format("{}: {} labels do not fill an image of {}", path.string(), labels.size(),
                                 fmt::join(extents, " x ")));
  }
  const auto width = extents[0], height = extents[1];
  auto bytes = npy_beginning(extents);
  bytes.reserve(bytes.size() + 2 * count);
  for (auto layer = labels; !layer.empty(); layer = layer.subspan(width * height)) {
    for (auto row = height; row-- > 0;) append_little_endian(bytes, layer.subspan(row * width, width));
  }
  write_text(path, bytes);
}

}  // namespace breccia

#include "rasters/raster_layout.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

namespace breccia {

namespace {

/// Reverses the order of the rows in each layer: from the top to the bottom, or back.
void reverse_rows(std::span<const std::size_t> extents, std::span<std::int32_t> values) {
  const auto width = extents[0], height = extents[1];
  for (auto layer = values; !layer.empty(); layer = layer.subspan(width * height)) {
    for (std::size_t row = 0; row < height / 2; ++row) {
      std::ranges::swap_ranges(layer.subspan(row * width, width), layer.subspan((height - 1 - row) * width, width));
    }
  }
}

}  // namespace

std::size_t pixel_count(const std::filesystem::path& file, std::span<const std::size_t> extents) {
  // Some gigabytes of memory: a small file may hold a vast number of equal pixels.
  constexpr auto most = (std::size_t{1} << 29) - 1;
  const auto refuse = [&](std::string_view expected) {
    throw InputError(
        fmt::format("{}: an image of {} pixels; expected {}", file.string(), fmt::join(extents, " x "), expected));
  };
  std::size_t count = 1;
  for (const auto extent : extents) {
    if (extent == 0) refuse("at least one along each axis");
    if (extent > most / count) refuse("fewer than 2^29; crop it, or take a coarser one");
    count *= extent;
  }
  return count;
}

void require_plausible_size(const std::filesystem::path& file, std::size_t bytes, std::size_t file_size) {
  constexpr std::size_t strongest_compression = 1032;  // largest ratio of compression by deflate
  constexpr auto always_possible = std::size_t{1} << 24;
  if (bytes <= always_possible || bytes / strongest_compression <= file_size) return;
  throw InputError(fmt::format("{}: the image would take {} bytes, which a file of {} bytes cannot hold: it is damaged",
                               file.string(), bytes, file_size));
}

std::vector<std::size_t> extents_of_array(const std::filesystem::path& file, std::span<const std::size_t> shape) {
  const auto refuse = [&](std::string_view expected) {
    throw InputError(fmt::format("{}: an array of shape ({}); {}", file.string(), fmt::join(shape, ", "), expected));
  };
  if (shape.size() != 2 && shape.size() != 3) refuse("expected two dimensions, [y][x], or three, [z][y][x]");
  constexpr std::size_t narrow = 4, wide = 16;
  if (shape.size() == 3 && (shape[2] == 3 || shape[2] == narrow) && std::min(shape[0], shape[1]) >= wide) {
    refuse("it looks like a colour picture; expected labels, one number a pixel");
  }
  return {shape.rbegin(), shape.rend()};
}

Raster raster_from_bottom(std::vector<std::size_t> extents, std::vector<std::int32_t> values) {
  if (extents.size() == 3 && extents[2] == 1) extents.pop_back();
  return {std::move(extents), std::move(values), {}};
}

Raster raster_from_top(std::vector<std::size_t> extents, std::vector<std::int32_t> values) {
  reverse_rows(extents, values);
  return raster_from_bottom(std::move(extents), std::move(values));
}

}  // namespace breccia

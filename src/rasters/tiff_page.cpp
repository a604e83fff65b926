#include "rasters/tiff_page.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "rasters/grey_levels.hpp"
#include "rasters/raster_layout.hpp"

namespace breccia {

namespace {

using std::uint16_t;
using std::uint32_t;

bool is_one_of(unsigned value, std::initializer_list<unsigned> allowed) {
  return std::ranges::find(allowed, value) != allowed.end();
}

ElementType sample_type(const TiffFile& tiff, unsigned bits) {
  using enum ElementType::Kind;
  switch (const auto format = tiff.tag(TIFFTAG_SAMPLEFORMAT, uint16_t{SAMPLEFORMAT_UINT})) {
    case SAMPLEFORMAT_UINT:
    case SAMPLEFORMAT_VOID:
      if (is_one_of(bits, {1, 2, 4, 8, 16, 32, 64})) return {unsigned_integer, bits / 8};
      break;
    case SAMPLEFORMAT_INT:
      if (is_one_of(bits, {8, 16, 32, 64})) return {signed_integer, bits / 8};
      break;
    case SAMPLEFORMAT_IEEEFP:
      if (is_one_of(bits, {32, 64})) return {floating_point, bits / 8};
      break;
    default:
      tiff.refuse(fmt::format("samples of format {}", format), "whole numbers");
  }
  tiff.refuse(fmt::format("samples of {} bits", bits), "1, 2, 4, 8, 16, 32 or 64, or floating point of 32 or 64");
}

Shades shades_of(uint16_t colours) {
  if (colours == PHOTOMETRIC_PALETTE) return Shades::palette;
  return colours == PHOTOMETRIC_MINISWHITE ? Shades::falling : Shades::rising;
}

std::size_t bytes_for(std::size_t pixels, const TiffPage& page) {
  return (pixels * page.channels * page.bits + 7) / 8;
}

/// Calls action(bytes) for each row of a page that is stored in strips.
template <class Action>
void for_each_stripped_row(const TiffFile& tiff, const TiffPage& page, const Action& action) {
  const auto row_size = TIFFScanlineSize64(tiff.handle());
  require_plausible_size(tiff.path(), row_size, tiff.size());
  if (row_size != bytes_for(page.width, page)) tiff.refuse_damaged();
  std::string bytes(row_size, '\0');
  for (std::size_t row = 0; row < page.height; ++row) {
    if (TIFFReadScanline(tiff.handle(), bytes.data(), static_cast<uint32_t>(row), 0) < 0) tiff.refuse_damaged();
    action(std::string_view(bytes));
  }
}

/// Calls the action for the rows of a page that is stored in tiles. The width of a tile is a multiple of 16 pixels, so
/// a tile's row has whole bytes.
template <class Action>
void for_each_tiled_row(const TiffFile& tiff, const TiffPage& page, const Action& action) {
  const std::size_t tile_width = tiff.tag(TIFFTAG_TILEWIDTH, uint32_t{0});
  const std::size_t tile_height = tiff.tag(TIFFTAG_TILELENGTH, uint32_t{0});
  if (tile_width == 0 || tile_width % 16 != 0 || tile_height == 0) {
    tiff.refuse(fmt::format("tiles of {} x {} pixels", tile_width, tile_height), "multiples of 16");
  }
  const auto tile_row = bytes_for(tile_width, page);
  const auto tiles = (page.width + tile_width - 1) / tile_width;
  static_cast<void>(pixel_count(tiff.path(), std::array{tiles, tile_width, tile_height}));
  require_plausible_size(tiff.path(), tiles * tile_row * tile_height, tiff.size());
  if (TIFFTileSize64(tiff.handle()) != tile_row * tile_height) tiff.refuse_damaged();
  std::string tile(tile_row * tile_height, '\0');
  std::string band(tiles * tile.size(), '\0');  // rows of tiles that lie side by side
  for (std::size_t top = 0; top < page.height; top += tile_height) {
    for (std::size_t column = 0; column < tiles; ++column) {
      const auto x = static_cast<uint32_t>(column * tile_width);
      if (TIFFReadTile(tiff.handle(), tile.data(), x, static_cast<uint32_t>(top), 0, 0) < 0) tiff.refuse_damaged();
      for (std::size_t row = 0; row < tile_height; ++row) {
        std::ranges::copy(std::string_view(tile).substr(row * tile_row, tile_row),
                          band.begin() + static_cast<std::ptrdiff_t>((row * tiles + column) * tile_row));
      }
    }
    for (std::size_t row = 0; row < std::min(tile_height, page.height - top); ++row) {
      action(std::string_view(band).substr(row * tiles * tile_row, bytes_for(page.width, page)));
    }
  }
}

template <class Action>
void for_each_row(const TiffFile& tiff, const TiffPage& page, const Action& action) {
  if (TIFFIsTiled(tiff.handle()) != 0) {
    for_each_tiled_row(tiff, page, action);
  } else {
    for_each_stripped_row(tiff, page, action);
  }
}

}  // namespace

TiffPage page_layout(const TiffFile& tiff) {
  const auto width = tiff.tag(TIFFTAG_IMAGEWIDTH, uint32_t{0});
  const auto height = tiff.tag(TIFFTAG_IMAGELENGTH, uint32_t{0});
  const unsigned bits = tiff.tag(TIFFTAG_BITSPERSAMPLE, uint16_t{1});
  const auto channels = tiff.tag(TIFFTAG_SAMPLESPERPIXEL, uint16_t{1});
  const auto colours = tiff.tag(TIFFTAG_PHOTOMETRIC, uint16_t{PHOTOMETRIC_MINISBLACK});
  const bool is_rgb = colours == PHOTOMETRIC_RGB && is_one_of(channels, {3, 4});
  const bool is_grey = is_one_of(colours, {PHOTOMETRIC_MINISBLACK, PHOTOMETRIC_MINISWHITE}) && channels <= 2;
  if (!is_rgb && !is_grey && !(colours == PHOTOMETRIC_PALETTE && channels == 1)) {
    tiff.refuse(fmt::format("a picture with colour model {} and {} samples a pixel", colours, channels),
                "grey levels (model 0 or 1) or a palette (3), whose numbers are the labels");
  }
  const auto type = sample_type(tiff, bits);
  if (channels > 1) {
    if (type.kind != ElementType::Kind::unsigned_integer || !is_one_of(bits, {8, 16})) {
      tiff.refuse(fmt::format("{} samples of {} bits a pixel", channels, bits), "one sample a pixel");
    }
    if (tiff.tag(TIFFTAG_PLANARCONFIG, uint16_t{PLANARCONFIG_CONTIG}) != PLANARCONFIG_CONTIG) {
      tiff.refuse(fmt::format("{} samples a pixel in separate planes", channels), "one sample a pixel");
    }
  }
  const auto orientation = tiff.tag(TIFFTAG_ORIENTATION, uint16_t{ORIENTATION_TOPLEFT});
  if (!is_one_of(orientation, {ORIENTATION_TOPLEFT, ORIENTATION_BOTLEFT})) {
    tiff.refuse(fmt::format("a mirrored or rotated picture (orientation {})", orientation),
                "rows from the left, from the top (1) or the bottom (4)");
  }
  return {width, height, bits, channels, type, orientation == ORIENTATION_TOPLEFT, shades_of(colours)};
}

void append_page(std::vector<std::int32_t>& values, const TiffFile& tiff, const TiffPage& page) {
  if (page.bits < 8) {
    for_each_row(tiff, page, [&](std::string_view row) { append_packed(values, row, page.width, page.bits); });
  } else if (page.channels == 1) {
    for_each_row(tiff, page, [&](std::string_view row) { append_elements(values, tiff.path(), row, page.type); });
  } else {
    const uint16_t most = page.bits == 8 ? 255 : 65535;
    std::vector<std::int32_t> samples;
    for_each_row(tiff, page, [&](std::string_view row) { append_elements(samples, tiff.path(), row, page.type); });
    const auto levels = grey_levels(tiff.path(), {page.channels, most, {samples.begin(), samples.end()}});
    values.insert(values.end(), levels.begin(), levels.end());
  }
}

}  // namespace breccia

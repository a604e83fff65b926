#include "rasters/tiff_reader.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/display.hpp"
#include "rasters/imagej_description.hpp"
#include "rasters/raster_layout.hpp"
#include "rasters/tiff_file.hpp"
#include "rasters/tiff_page.hpp"

namespace breccia {

namespace {

bool is_thumbnail(const TiffFile& tiff) {
  return (tiff.tag(TIFFTAG_SUBFILETYPE, std::uint32_t{0}) & FILETYPE_REDUCEDIMAGE) != 0;
}

bool have_same_shape(const TiffPage& page, const TiffPage& other) {
  return page.width == other.width && page.height == other.height && page.is_from_the_top == other.is_from_the_top;
}

/// The unit of the resolution of a page [m], if it is a length.
std::optional<double> resolution_unit(const TiffFile& tiff, const std::optional<ImagejDescription>& imagej) {
  if (imagej && imagej->unit) return imagej->unit;
  switch (tiff.tag(TIFFTAG_RESOLUTIONUNIT, std::uint16_t{RESUNIT_INCH})) {
    case RESUNIT_INCH:
      return 0.0254;
    case RESUNIT_CENTIMETER:
      return 0.01;
    default:
      return {};
  }
}

/// Side of a pixel [m], if the page has it. Throws InputError if the pixel is not a square, or the voxel not a cube.
std::optional<double> pixel_side(const TiffFile& tiff, const std::optional<ImagejDescription>& imagej) {
  constexpr double tolerance = 1e-3;
  const auto unit = resolution_unit(tiff, imagej);
  const double per_unit_x = tiff.tag(TIFFTAG_XRESOLUTION, 0.0), per_unit_y = tiff.tag(TIFFTAG_YRESOLUTION, 0.0);
  const auto is_length = [](double number) { return std::isfinite(number) && number > 0.0; };
  if (!is_length(per_unit_x) || !is_length(per_unit_y)) return {};
  if (std::abs(per_unit_x / per_unit_y - 1.0) > tolerance) {
    tiff.refuse(fmt::format("the height of a pixel is {} of its width", three_digits(per_unit_x / per_unit_y)),
                "square pixels");
  }
  if (!unit) return {};
  if (imagej && imagej->unit && imagej->spacing && std::abs(*imagej->spacing * per_unit_x - 1.0) > tolerance) {
    tiff.refuse(fmt::format("layers lie {} of a pixel's width apart", three_digits(*imagej->spacing * per_unit_x)),
                "voxels that are cubes");
  }
  return *unit / per_unit_x;
}

/// Throws InputError if the pages of a file of ImageJ are not layers alone.
void refuse_channels(const TiffFile& tiff, const ImagejDescription& imagej) {
  if (imagej.channels == 1 && imagej.frames == 1) return;
  tiff.refuse(fmt::format("an ImageJ stack with channels ({}) or frames ({})", imagej.channels, imagej.frames),
              "one with slices alone");
}

/// Throws InputError if ImageJ has written a stack as one page, as it does above 4 GB.
void require_all_pages(const TiffFile& tiff, const ImagejDescription& imagej, std::size_t pages) {
  if (imagej.images <= pages) return;
  tiff.refuse(fmt::format("the last page of an ImageJ stack of {} images", imagej.images), "a page an image");
}

}  // namespace

Raster read_tiff(const std::filesystem::path& file, std::string_view bytes) {
  TiffFile tiff(file, bytes);
  const auto imagej = read_imagej_description(tiff.text_tag(TIFFTAG_IMAGEDESCRIPTION));
  if (imagej) refuse_channels(tiff, *imagej);
  const auto first = page_layout(tiff);
  const auto pixel = pixel_side(tiff, imagej);
  std::vector<std::size_t> extents{first.width, first.height, 0};
  std::vector<std::int32_t> values;
  do {
    if (is_thumbnail(tiff)) continue;
    const auto page = page_layout(tiff);
    if (!have_same_shape(page, first)) {
      tiff.refuse(fmt::format("a picture of {} x {} pixels", page.width, page.height),
                  fmt::format("{} x {} as on page 1, with rows in the same order", first.width, first.height));
    }
    ++extents[2];
    static_cast<void>(pixel_count(file, extents));
    append_page(values, tiff, page);
  } while (tiff.next_page());
  static_cast<void>(pixel_count(file, extents));  // the extents of all pages are checked, even if these are thumbnails
  if (imagej) require_all_pages(tiff, *imagej, extents[2]);
  auto raster = first.is_from_the_top ? raster_from_top(std::move(extents), std::move(values))
                                      : raster_from_bottom(std::move(extents), std::move(values));
  raster.pixel = pixel;
  raster.shades = first.shades;
  return raster;
}

}  // namespace breccia

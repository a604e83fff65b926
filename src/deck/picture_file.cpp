#include "deck/picture_file.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/rasters/raster_reader.hpp"

namespace breccia {
namespace {

/// Reads `crop`; its extents are empty after a mistake.
PictureCrop read_crop(const Section& packing, int dimensions) {
  constexpr Range place = {.lower = 0.0, .upper = 1e9}, extent = {.lower = 1.0, .upper = 1e9};
  const auto section = packing.section("crop");
  const auto read = [&section](const char* key, const Range& range) {
    return static_cast<std::size_t>(section.integer(key, range));
  };
  PictureCrop crop;
  crop.left = read("left", place);
  crop.top = read("top", place);
  crop.extents = {read("width", extent), read("height", extent)};
  if (dimensions == 3) {
    crop.lowest = read("lowest", place);
    crop.extents.push_back(read("depth", extent));
  } else {
    section.refuse({"lowest", "depth"},
                   "a box of two dimensions takes one image; packing.page takes a layer of a stack");
  }
  if (std::ranges::count(crop.extents, 0U) > 0) crop.extents.clear();
  return crop;
}

/// Reduces a stack to one of its pages, counted from 1. Reports a stack for which no page is given, and a page that the
/// file does not have.
bool take_page(const Section& packing, std::optional<std::int64_t> page, Raster& raster) {
  const auto pages = raster.extents.size() > 2 ? raster.extents[2] : 1;
  if (packing.has("page") && page.value_or(0) < 1) return false;  // a bad page has been reported already
  if (page && static_cast<std::size_t>(*page) > pages) {
    packing.report("page", fmt::format("expected a page from 1 to {}, got {}", pages, *page));
    return false;
  }
  if (!page && pages > 1) {
    // Programs that read colours write arrays of [y][x][colour].
    const bool may_be_colours = raster.extents[0] == 3 || raster.extents[0] == 4;
    packing.report(
        "file", fmt::format("a stack of {} images: expected one image in a box of two dimensions; {}", pages,
                            may_be_colours ? "if it is one image in colours, save one of them, or labels"
                                           : "packing.page = 1 takes the first one, dimensions = 3 the whole stack"));
    return false;
  }
  const auto pixels = static_cast<std::int64_t>(raster.extents[0] * raster.extents[1]);
  const auto first = raster.values.begin() + (page.value_or(1) - 1) * pixels;
  if (pages > 1) raster.values = std::vector<std::int32_t>(first, first + pixels);
  raster.extents.resize(2);
  return true;
}

/// The key that the extents of a picture follow from.
std::string cropped_key(const Section& packing) {
  return packing.has("crop") ? "crop" : "file";
}

/// Reports an image that is not a square.
bool require_square(const Section& packing, const Raster& raster) {
  const auto columns = raster.extents[0], rows = raster.extents[1];
  if (columns == rows) return true;
  const auto side = std::min(columns, rows);
  packing.report(cropped_key(packing),
                 fmt::format("expected a square image, since boxes are square, got {} x {} pixels; crop = {{ left = 0, "
                             "top = 0, width = {}, height = {} }} takes a square of it",
                             columns, rows, side, side));
  return false;
}

/// Reports one image where a box of three dimensions needs a stack.
bool require_stack(const Section& packing, const Raster& raster) {
  if (raster.extents.size() > 2) return true;
  packing.report("file", fmt::format("expected a stack of images in a box of three dimensions, got one of {} pixels",
                                     fmt::join(raster.extents, " x ")));
  return false;
}

/// Reports a stack that is not a cube of voxels.
bool require_cube(const Section& packing, const Raster& raster) {
  const auto [fewest, most] = std::ranges::minmax(raster.extents);
  if (fewest == most) return true;
  packing.report(
      cropped_key(packing),
      fmt::format("expected a cube of voxels, since boxes are cubic, got {0} voxels; crop = {{ left = 0, top "
                  "= 0, lowest = 0, width = {1}, height = {1}, depth = {1} }} takes a cube of it",
                  fmt::join(raster.extents, " x "), fewest));
  return false;
}

/// Reduces a picture to a part of it. Reports a part that reaches beyond the picture.
bool take_part(const Section& packing, const PictureCrop& crop, Raster& raster) {
  const auto& extents = crop.extents;
  if (extents.size() != raster.extents.size()) return false;  // reported, or to be reported as no stack
  // The rows of a raster rise from the bottom, and `top` is counted as a viewer shows the picture.
  const std::array<std::size_t, 3> ends = {crop.left + extents[0], crop.top + extents[1],
                                           extents.size() > 2 ? crop.lowest + extents[2] : 1};
  for (std::size_t axis = 0; axis < extents.size(); ++axis) {
    if (ends[axis] <= raster.extents[axis]) continue;
    packing.report("crop",
                   fmt::format("the pixels {} to {} {} reach beyond a picture of {}", ends[axis] - extents[axis],
                               ends[axis], std::array{"from the left", "from the top", "from the lowest"}[axis],
                               fmt::join(raster.extents, " x ")));
    return false;
  }
  const auto columns = raster.extents[0], rows = raster.extents[1], bottom = rows - ends[1];
  std::vector<std::int32_t> part;
  for (auto layer = crop.lowest; layer < ends[2]; ++layer) {
    for (auto row = bottom; row < bottom + extents[1]; ++row) {
      const auto first =
          raster.values.begin() + static_cast<std::ptrdiff_t>((layer * rows + row) * columns + crop.left);
      part.insert(part.end(), first, first + static_cast<std::ptrdiff_t>(extents[0]));
    }
  }
  raster.values = std::move(part);
  raster.extents = extents;
  return true;
}

}  // namespace

std::optional<AskedPicture> asked_picture(const Section& packing, int dimensions) {
  AskedPicture asked;
  asked.page = packing.optional_integer("page", Range::positive());
  if (dimensions == 3) packing.refuse({"page"}, "a box of three dimensions takes the whole stack");
  if (packing.has("crop")) asked.crop = read_crop(packing, dimensions);
  const auto written = packing.text("file");
  if (written.empty()) return std::nullopt;
  auto [file, array] = raster_name(written);
  asked.file = packing.file("file", file.string());
  asked.array = std::move(array);
  if (asked.file.empty()) return std::nullopt;
  return asked;
}

std::string name_in_cache(const AskedPicture& asked, int dimensions) {
  auto name = fmt::format("{}\n{}\npage {} in {} dimensions", asked.file.string(), asked.array, asked.page.value_or(0),
                          dimensions);
  if (asked.crop) {
    const auto& [left, top, lowest, extents] = *asked.crop;
    name += fmt::format(", {} {} {} {}", left, top, lowest, fmt::join(extents, " "));
  }
  return name;
}

std::optional<Raster> read_picture(const Section& packing, const AskedPicture& asked, int dimensions) {
  std::optional<Raster> raster;
  packing.report_errors_of("file", [&] { raster = read_raster(asked.file, asked.array); });
  if (!raster) return std::nullopt;
  if (dimensions == 2 && !take_page(packing, asked.page, *raster)) return std::nullopt;
  if (dimensions == 3 && !require_stack(packing, *raster)) return std::nullopt;
  if (asked.crop && !take_part(packing, *asked.crop, *raster)) return std::nullopt;
  const bool fits = dimensions == 3 ? require_cube(packing, *raster) : require_square(packing, *raster);
  return fits ? std::move(raster) : std::nullopt;
}

}  // namespace breccia

#include "deck/image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/microstructure/pixel_labels.hpp"
#include "breccia/rasters/raster_reader.hpp"

#include "deck/materials.hpp"
#include "deck/packing.hpp"
#include "deck/rounding.hpp"
#include "study/limits.hpp"
#include "study/stage_rules.hpp"

namespace breccia {
namespace {

/// The number of the filler of a material, which is added if it is new.
std::size_t filler_of(const Material& material, Stage& stage) {
  const auto has_name = [&](const Filler& filler) { return filler.material.name == material.name; };
  const auto known = std::ranges::find_if(stage.fillers, has_name);
  if (known != stage.fillers.end()) return static_cast<std::size_t>(known - stage.fillers.begin());
  stage.fillers.push_back({.material = material});
  return stage.fillers.size() - 1;
}

/// Reads `labels = [{ value = 0, material = "..." }, ...]` and adds the fillers of the stage. Empty where a value is
/// not known because of a mistake.
std::vector<ValueLabel> read_labels(const Section& packing, const std::vector<ShiftedMaterial>& materials,
                                    Stage& stage) {
  constexpr Range values = {.lower = static_cast<double>(std::numeric_limits<std::int32_t>::min()),
                            .upper = static_cast<double>(std::numeric_limits<std::int32_t>::max())};
  const auto& matrix = name_of(stage.matrix);
  std::vector<ValueLabel> table;
  bool has_matrix = false, has_values = true;
  const auto sections = packing.sections("labels");
  for (const auto& section : sections) {
    auto& entry = table.emplace_back();
    has_values = has_values && section.kind("value") == Kind::integer;
    entry.value = static_cast<std::int32_t>(section.integer("value", values));
    if (!matrix.empty() && section.kind("material") == Kind::text && section.optional_text("material") == matrix) {
      has_matrix = true;
      continue;
    }
    const auto material = read_material_reference(section, "material", materials);
    if (!material.name.empty()) entry.label = static_cast<Label>(filler_of(material, stage) + 1);
  }
  // An unknown matrix has been reported already.
  if (!sections.empty() && !has_matrix && !matrix.empty()) {
    packing.report("labels", fmt::format("no label is of the matrix of the stage, \"{}\"", matrix));
  }
  if (stage.fillers.size() > allowed::most_fillers) {
    packing.report("labels", fmt::format("expected at most {} materials beside the matrix, got {}",
                                         allowed::most_fillers, stage.fillers.size()));
  }
  for (const auto& mistake : mistakes_of_phases(stage)) packing.report("labels", mistake);
  return has_values ? table : std::vector<ValueLabel>();
}

/// The keys of a deck for an image, apart from the labels of its values.
struct AskedPixels {
  std::string file, array;
  std::optional<std::int64_t> page;
};

/// The properties of an image that are known without its values.
struct RasterFrame {
  std::vector<std::size_t> extents;
  std::optional<double> pixel;  ///< side of a pixel, as Raster::pixel
};

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

/// Reports an image that is not a square.
bool require_square(const Section& packing, const Raster& raster) {
  const auto columns = raster.extents[0], rows = raster.extents[1];
  if (columns == rows) return true;
  const auto side = std::min(columns, rows);
  packing.report("file", fmt::format("expected a square image, since boxes are square, got {} x {} pixels; crop it to "
                                     "{} x {} (ImageMagick: convert IN -crop {}x{}+0+0 +repage OUT)",
                                     columns, rows, side, side, side, side));
  return false;
}

/// Reports an image that is not a cube of voxels.
bool require_cube(const Section& packing, const Raster& raster) {
  if (raster.extents.size() < 3) {
    packing.report("file", fmt::format("expected a stack of images in a box of three dimensions, got one of {} pixels",
                                       fmt::join(raster.extents, " x ")));
    return false;
  }
  const auto [fewest, most] = std::ranges::minmax(raster.extents);
  if (fewest == most) return true;
  packing.report("file",
                 fmt::format("expected a cube of voxels, since boxes are cubic, got {} voxels; crop it to {}",
                             fmt::join(raster.extents, " x "), fmt::join(std::array{fewest, fewest, fewest}, " x ")));
  return false;
}

/// Reads one image, a page of a stack.
bool take_image(const Section& packing, std::optional<std::int64_t> page, Raster& raster) {
  return take_page(packing, page, raster) && require_square(packing, raster);
}

/// The image that a stage requests; nothing where it is not known because of a mistake.
template <int dim>
std::optional<AskedPixels> asked_pixels(const Section& packing, ImagePacking<dim>& image) {
  const auto page = packing.optional_integer("page", Range::positive());
  if (dim == 3) packing.refuse({"page"}, "a box of three dimensions takes the whole stack");
  const auto written = packing.text("file");
  if (written.empty()) return std::nullopt;
  auto [file, array] = raster_name(written);
  image.file = packing.file("file", file.string());
  image.array = std::move(array);
  if (image.file.empty()) return std::nullopt;
  return AskedPixels{image.file.string(), image.array, page};
}

/// The pixels of a square image, or the voxels of a cubic stack in a box of three dimensions. The file is read only if
/// the cache of files does not hold them.
template <int dim>
class PixelsOfStage {
 public:
  /// The section must outlive this object.
  PixelsOfStage(const Section& packing, AskedPixels asked)
      : packing_(packing), asked_(std::move(asked)), frame_(packing.file_cache().find<RasterFrame>(key())) {
    if (frame_ || !read()) return;
    frame_ = packing.file_cache().keep(key(), RasterFrame{raster_->extents, raster_->pixel});
  }

  /// The properties of the image; null where it cannot be read, which has been reported.
  [[nodiscard]] const RasterFrame* frame() const { return frame_.get(); }

  /// The image of labels that fills a box of this side [m]; null where it cannot be read. Throws InputError.
  [[nodiscard]] SharedImage<dim> labelled(const std::vector<ValueLabel>& table, double side, Walls walls) {
    auto known_by = fmt::format("{}\nside {} walls {}", key(), side, static_cast<int>(walls));
    for (const auto& [value, label] : table) known_by += fmt::format("\n{} is {}", value, label);
    auto& cache = packing_.file_cache();
    if (auto known = cache.find<LabelImage<dim>>(known_by)) return known;
    if (!raster_ && !read()) return nullptr;
    const int pixels = static_cast<int>(raster_->extents[0]);
    LabelImage<dim> image = {
        .pixels = {}, .pixel_side = side / pixels, .walls = walls, .labels = pixel_labels(raster_->values, table)};
    image.pixels.fill(pixels);
    return cache.keep(known_by, std::move(image));
  }

 private:
  /// The key of these pixels in the cache of files.
  [[nodiscard]] std::string key() const {
    return fmt::format("{}\n{}\npage {} in {} dimensions", asked_.file, asked_.array, asked_.page.value_or(0), dim);
  }

  /// Whether the file could be read.
  bool read() {
    packing_.report_errors_of("file", [&] { raster_ = read_raster(asked_.file, asked_.array); });
    if (!raster_) return false;
    const bool fits = dim == 3 ? require_cube(packing_, *raster_) : take_image(packing_, asked_.page, *raster_);
    if (!fits) raster_.reset();
    return fits;
  }

  const Section& packing_;
  AskedPixels asked_;
  std::shared_ptr<const RasterFrame> frame_;
  std::optional<Raster> raster_;
};

/// The side of the box [m] from `box` or `pixel` or both, which must agree; not a number where that is not
/// known because of a mistake.
double read_side(const Section& section, const Section& packing, const RasterFrame* raster) {
  const auto box = section.optional_quantity("box", Dimension::length, allowed::side);
  const auto pixel = packing.optional_quantity("pixel", Dimension::length, Range::positive());
  if (!section.has("box") && !packing.has("pixel")) {
    const bool has_hint = raster && raster->pixel;
    packing.report("pixel", fmt::format("missing, expected the side of a pixel, such as \"2 um\", or box{}",
                                        has_hint ? fmt::format(" (the resolution in the file stands for pixels of {})",
                                                               readable(*raster->pixel, Dimension::length))
                                                 : ""));
  }
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (!raster || !pixel || !(*pixel > 0.0)) return box.value_or(unknown);
  const auto pixels = static_cast<double>(raster->extents[0]);
  const double side = as_typed(pixels * *pixel);
  if (!accepts(allowed::side, side)) {
    packing.report("pixel", fmt::format("{:.0f} pixels of {} give a box of {}", pixels,
                                        readable(*pixel, Dimension::length), readable(side, Dimension::length)));
    return unknown;
  }
  if (!box) return side;
  constexpr double rounding = 1e-9;
  if (*box > 0.0 && std::abs(side / *box - 1.0) > rounding) {
    section.report("box", fmt::format("{:.0f} pixels of {} are {}: expected that, or box or packing.pixel alone",
                                      pixels, readable(*pixel, Dimension::length), readable(side, Dimension::length)));
  }
  return *box;
}

/// Pixels along each side of the image of a stage; nothing where it could not be read, which has been reported.
struct PixelsAlong {
  template <int dim>
  std::optional<int> operator()(const ImagePacking<dim>& pixels) const {
    return pixels.image ? std::optional(pixels.image->pixels[0]) : std::nullopt;
  }
  template <class Packing>
  std::optional<int> operator()(const Packing&) const {
    return std::nullopt;
  }
};

/// Reads the image of a box of so many dimensions, and the side of the box.
template <int dim>
ImagePacking<dim> read_image_in(const Section& section, const Section& packing, const std::vector<ValueLabel>& table,
                                double& side) {
  ImagePacking<dim> image;
  std::optional<PixelsOfStage<dim>> pixels;
  if (const auto asked = asked_pixels(packing, image)) pixels.emplace(packing, *asked);
  const auto* const frame = pixels ? pixels->frame() : nullptr;
  side = read_side(section, packing, frame);
  const bool is_periodic = packing.optional_boolean("periodic").value_or(false);
  if (frame == nullptr || table.empty()) return image;
  packing.report_errors_of(
      "labels", [&] { image.image = pixels->labelled(table, side, is_periodic ? Walls::periodic : Walls::hard); });
  return image;
}

}  // namespace

bool has_image(const Section& stage) {
  if (stage.kind("packing") != Kind::table) return false;
  return has_method(stage.section("packing"), PackingName::image);
}

void read_image(const Section& section, const std::vector<ShiftedMaterial>& materials, Stage& stage) {
  const auto packing = section.section("packing");
  constexpr auto filler_elsewhere =
      "the fillers of an image are the materials of its labels: packing.labels = [{ value = 0, material = \"...\" }, "
      "...]";
  section.refuse({"filler"}, filler_elsewhere);
  packing.refuse({"walls"}, "an image has periodic = true or false");
  packing.refuse({"seed"}, "nothing in an image is at random");
  const auto table = read_labels(packing, materials, stage);
  if (stage.dimensions() == 3) {
    stage.packing = read_image_in<3>(section, packing, table, stage.side);
  } else {
    stage.packing = read_image_in<2>(section, packing, table, stage.side);
  }
}

int cells_of_points(const Section& section, const Stage& stage) {
  const auto known = visit_nested(PixelsAlong(), stage.packing);
  if (!known) return static_cast<int>(allowed::cells.lower);
  const int pixels = *known;
  if (pixels % 2 == 0 && accepts(allowed::cells, 0.5 * pixels)) return pixels / 2;
  const bool is_flat = stage.dimensions() == 2;
  section.report(
      "cells",
      fmt::format("missing: cells of {} points cannot give each of {} one point; cells = {} gives each {} "
                  "points, and an image of an even number of pixels, {} or more, needs no cells",
                  is_flat ? "2 x 2" : "2 x 2 x 2",
                  is_flat ? fmt::format("{0} x {0} pixels", pixels) : fmt::format("{0} x {0} x {0} voxels", pixels),
                  std::max(pixels, static_cast<int>(allowed::cells.lower)), is_flat ? "four" : "eight",
                  2.0 * allowed::cells.lower));
  return static_cast<int>(allowed::cells.lower);
}

}  // namespace breccia

#include "deck/image.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "breccia/microstructure/pixel_labels.hpp"

#include "deck/grey_rule.hpp"
#include "deck/materials.hpp"
#include "deck/packing.hpp"
#include "deck/picture_file.hpp"
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

/// Whether a key has the name of the matrix of a stage.
bool names_matrix(const Section& section, const std::string& key, const Stage& stage) {
  const auto matrix = name_of(stage.matrix);
  return !matrix.empty() && section.kind(key) == Kind::text && section.optional_text(key) == matrix;
}

/// How the values of the pixels become labels: by a table of the values, or by a threshold.
using PixelRule = std::variant<std::vector<ValueLabel>, GreyRule>;

/// Reads the name of a material of a label, and adds it to the fillers of the stage unless it is the matrix; 0 after a
/// mistake, too.
Label read_label(const Section& section, const std::string& key, const std::vector<ShiftedMaterial>& materials,
                 Stage& stage) {
  if (names_matrix(section, key, stage)) {
    static_cast<void>(section.optional_text(key));
    return 0;
  }
  const auto material = read_material_reference(section, key, materials);
  return material.name.empty() ? Label{0} : static_cast<Label>(filler_of(material, stage) + 1);
}

/// Reads `labels = [{ value = 0, material = "..." }, ...]` and adds the fillers of the stage. Nothing where a value is
/// not known because of a mistake.
std::optional<PixelRule> read_value_labels(const Section& packing, const std::vector<ShiftedMaterial>& materials,
                                           Stage& stage) {
  constexpr Range values = {.lower = static_cast<double>(std::numeric_limits<std::int32_t>::min()),
                            .upper = static_cast<double>(std::numeric_limits<std::int32_t>::max())};
  std::vector<ValueLabel> table;
  bool has_matrix = false, has_values = true;
  const auto sections = packing.sections("labels");
  for (const auto& section : sections) {
    has_values = has_values && section.kind("value") == Kind::integer;
    has_matrix = has_matrix || names_matrix(section, "material", stage);
    const auto value = static_cast<std::int32_t>(section.integer("value", values));
    table.push_back({value, read_label(section, "material", materials, stage)});
  }
  // An unknown matrix has been reported already.
  if (const auto matrix = name_of(stage.matrix); !sections.empty() && !has_matrix && !matrix.empty()) {
    packing.report("labels", fmt::format("no label is of the matrix of the stage, \"{}\"", matrix));
  }
  return has_values && !table.empty() ? std::optional<PixelRule>(std::move(table)) : std::nullopt;
}

/// Reads `threshold`, `smooth` and `labels = { dark = "...", bright = "..." }`, and adds the fillers of the stage.
std::optional<PixelRule> read_threshold_labels(const Section& packing, const std::vector<ShiftedMaterial>& materials,
                                               Stage& stage) {
  auto rule = read_grey_rule(packing);
  if (packing.kind("labels") != Kind::table) {
    packing.report("labels",
                   "expected the materials of the pixels up to packing.threshold and above it, as in { dark = "
                   "\"binder\", bright = \"glass\" }");
    return std::nullopt;
  }
  const auto sides = packing.section("labels");
  const bool has_matrix = names_matrix(sides, "dark", stage) || names_matrix(sides, "bright", stage);
  rule.dark = read_label(sides, "dark", materials, stage);
  rule.bright = read_label(sides, "bright", materials, stage);
  const auto matrix = name_of(stage.matrix);
  if (matrix.empty() || !sides.has("dark") || !sides.has("bright")) return std::nullopt;
  if (!has_matrix) {
    packing.report("labels", fmt::format("neither side of the threshold is the matrix of the stage, \"{}\"", matrix));
  } else if (names_matrix(sides, "dark", stage) && names_matrix(sides, "bright", stage)) {
    packing.report("labels", fmt::format("both sides of the threshold are \"{}\"", matrix));
  }
  return rule;
}

/// Reads the keys that say how the values of the pixels become labels.
std::optional<PixelRule> read_pixel_rule(const Section& packing, const std::vector<ShiftedMaterial>& materials,
                                         Stage& stage) {
  if (packing.has("threshold")) return read_threshold_labels(packing, materials, stage);
  packing.refuse({"smooth"}, "the medians of grey values: expected packing.threshold, too");
  if (packing.kind("labels") == Kind::table) {
    const auto sides = packing.section("labels");
    if (sides.has("dark") || sides.has("bright")) {
      sides.accept_all_keys();
      packing.report("labels",
                     "dark and bright are the two sides of packing.threshold: expected threshold = \"otsu\" or a "
                     "grey value, too");
      return std::nullopt;
    }
  }
  return read_value_labels(packing, materials, stage);
}

/// Reads the labels of an image and reports fillers that no stage may have.
std::optional<PixelRule> read_labels(const Section& packing, const std::vector<ShiftedMaterial>& materials,
                                     Stage& stage) {
  auto rule = read_pixel_rule(packing, materials, stage);
  if (stage.fillers.size() > allowed::most_fillers) {
    packing.report("labels", fmt::format("expected at most {} materials beside the matrix, got {}",
                                         allowed::most_fillers, stage.fillers.size()));
  }
  for (const auto& mistake : mistakes_of_phases(stage)) packing.report("labels", mistake);
  return rule;
}

/// The properties of an image that are known without its values.
struct RasterFrame {
  std::vector<std::size_t> extents;
  std::optional<double> pixel;  ///< side of a pixel, as Raster::pixel
};

/// Labels in the place of the pixels of a picture, and how a grey one became labels.
template <int dim>
struct LabelledPicture {
  SharedImage<dim> image;
  std::optional<GreySegmentation> segmentation = {};
};

/// Reports how to label the pixels of a grey picture, if some have values without a label that look like grey values.
void point_to_threshold(const Section& packing, const std::vector<std::int32_t>& values,
                        const std::vector<ValueLabel>& table) {
  std::set<std::int32_t> unlabelled(values.begin(), values.end());
  for (const auto& entry : table) unlabelled.erase(entry.value);
  constexpr std::size_t several = 3;
  if (unlabelled.size() < several) return;
  packing.report("labels",
                 "in a grey picture a threshold divides the values: packing.threshold = \"otsu\" with labels = "
                 "{ dark = \"...\", bright = \"...\" } (docs/tutorial-image.md)");
}

/// The pixels of a square image, or the voxels of a cubic stack in a box of three dimensions. The file is read only if
/// the cache of files does not hold them.
template <int dim>
class PixelsOfStage {
 public:
  /// The section must outlive this object.
  PixelsOfStage(const Section& packing, AskedPicture asked)
      : packing_(packing), asked_(std::move(asked)), frame_(packing.file_cache().find<RasterFrame>(key())) {
    if (frame_ || !read()) return;
    frame_ = packing.file_cache().keep(key(), RasterFrame{raster_->extents, raster_->pixel});
  }

  /// The properties of the image; null where it cannot be read, which has been reported.
  [[nodiscard]] const RasterFrame* frame() const { return frame_.get(); }

  /// The labels that fill a box of this side [m]; null where it cannot be read. Reports values that the rule does not
  /// take.
  [[nodiscard]] std::shared_ptr<const LabelledPicture<dim>> labelled(const PixelRule& rule, double side, Walls walls) {
    const auto known_by = fmt::format("{}\nside {} walls {}{}", key(), side, static_cast<int>(walls), in_words(rule));
    auto& cache = packing_.file_cache();
    if (auto known = cache.find<LabelledPicture<dim>>(known_by)) return known;
    if (!raster_ && !read()) return nullptr;
    const int pixels = static_cast<int>(raster_->extents[0]);
    LabelImage<dim> image = {.pixels = {}, .pixel_side = side / pixels, .walls = walls, .labels = {}};
    image.pixels.fill(pixels);
    LabelledPicture<dim> made;
    if (const auto* const grey = std::get_if<GreyRule>(&rule)) {
      packing_.report_errors_of("threshold", [&] {
        auto [segmentation, labels] = grey_labels(*raster_, *grey);
        made.segmentation = segmentation;
        image.labels = std::move(labels);
      });
    } else {
      const auto& table = std::get<std::vector<ValueLabel>>(rule);
      packing_.report_errors_of("labels", [&] { image.labels = pixel_labels(raster_->values, table); });
      if (image.labels.empty()) point_to_threshold(packing_, raster_->values, table);
    }
    if (image.labels.empty()) return nullptr;
    made.image = std::make_shared<const LabelImage<dim>>(std::move(image));
    return cache.keep(known_by, std::move(made));
  }

 private:
  /// The key of these pixels in the cache of files.
  [[nodiscard]] std::string key() const { return name_in_cache(asked_, dim); }

  /// What distinguishes a rule from others in the cache of files.
  static std::string in_words(const PixelRule& rule) {
    if (const auto* const grey = std::get_if<GreyRule>(&rule)) {
      const auto threshold = grey->threshold ? fmt::format("{}", *grey->threshold) : "otsu";
      return fmt::format("\nthreshold {} of medians {}: {}, {}", threshold, grey->median_side, grey->dark,
                         grey->bright);
    }
    std::string text;
    for (const auto& [value, label] : std::get<std::vector<ValueLabel>>(rule)) {
      text += fmt::format("\n{} is {}", value, label);
    }
    return text;
  }

  /// Whether the file could be read.
  bool read() {
    raster_ = read_picture(packing_, asked_, dim);
    return raster_.has_value();
  }

  const Section& packing_;
  AskedPicture asked_;
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
ImagePacking<dim> read_image_in(const Section& section, const Section& packing, const std::optional<PixelRule>& rule,
                                Walls walls, double& side) {
  ImagePacking<dim> image;
  const auto asked = asked_picture(packing, dim);
  std::optional<PixelsOfStage<dim>> pixels;
  if (asked) {
    image.file = asked->file;
    image.array = asked->array;
    image.crop = asked->crop;
    pixels.emplace(packing, *asked);
  }
  const auto* const frame = pixels ? pixels->frame() : nullptr;
  side = read_side(section, packing, frame);
  if (const auto is_periodic = packing.optional_boolean("periodic")) {
    walls = *is_periodic ? Walls::periodic : Walls::hard;
  }
  if (frame == nullptr || !rule) return image;
  if (const auto labelled = pixels->labelled(*rule, side, walls)) {
    image.image = labelled->image;
    image.segmentation = labelled->segmentation;
  }
  return image;
}

}  // namespace

bool has_image(const Section& stage) {
  if (stage.kind("packing") != Kind::table) return false;
  return has_method(stage.section("packing"), PackingName::image);
}

void read_image(const Section& section, const std::vector<ShiftedMaterial>& materials, Walls walls, Stage& stage) {
  const auto packing = section.section("packing");
  constexpr auto filler_elsewhere =
      "the fillers of an image are the materials of its labels: packing.labels = [{ value = 0, material = \"...\" }, "
      "...]";
  section.refuse({"filler"}, filler_elsewhere);
  packing.refuse({"walls"}, "an image has periodic = true or false");
  packing.refuse({"seed"}, "nothing in an image is at random");
  const auto rule = read_labels(packing, materials, stage);
  if (stage.dimensions() == 3) {
    stage.packing = read_image_in<3>(section, packing, rule, walls, stage.side);
  } else {
    stage.packing = read_image_in<2>(section, packing, rule, walls, stage.side);
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

#include "study/picture_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/nested_variant.hpp"

#include "microstructure/image/image_sides.hpp"

namespace breccia {
namespace {

std::string words_on_side(const Stage& stage, const char* name, const GreySide& side) {
  return fmt::format("{} = {}, {:.1f} %, grey values {} to {}, mean {:.1f}", name, material_of_label(stage, side.label),
                     100.0 * side.share, side.darkest, side.brightest, side.mean);
}

struct WordsOnThreshold {
  const Stage& stage;

  template <int dim>
  std::vector<std::string> operator()(const ImagePacking<dim>& pixels) const {
    if (!pixels.segmentation) return {};
    const auto& made = *pixels.segmentation;
    const auto side = made.median_side;
    const auto square = dim == 3 ? fmt::format("{0} x {0} x {0} voxels", side) : fmt::format("{0} x {0} pixels", side);
    return {fmt::format("threshold {:g}{}{}", made.threshold, made.is_otsu ? " (Otsu)" : "",
                        side > 1 ? fmt::format(" of the medians of {}, which close gaps of fewer than {} pixels and "
                                               "remove what is as thin",
                                               square, (side + 1) / 2)
                                 : ""),
            words_on_side(stage, "dark", made.dark), words_on_side(stage, "bright", made.bright),
            fmt::format("bright {:.1f} to {:.1f} % at thresholds of {:.4g} to {:.4g}, separability {:.2f}",
                        100.0 * made.bright_at_lower, 100.0 * made.bright_at_higher, made.threshold - made.margin,
                        made.threshold + made.margin, made.separability)};
  }
  template <class Packing>
  std::vector<std::string> operator()(const Packing&) const {
    return {};
  }
};

struct WordsOnSides {
  template <int dim>
  std::string operator()(const ImagePacking<dim>& pixels) const {
    if (!pixels.image) return {};
    const auto seam = seam_of(*pixels.image);
    return fmt::format(
        "they cut {:.0f} % of the filler; opposite ones differ in {:.0f} % of their pixels, neighbouring "
        "{} inside in up to {:.0f} %",
        100.0 * cut_share(*pixels.image), 100.0 * seam.across, dim == 3 ? "layers" : "lines", 100.0 * seam.most_inside);
  }
  template <class Packing>
  std::string operator()(const Packing&) const {
    return {};
  }
};

struct WordsOnCrop {
  template <int dim>
  std::string operator()(const ImagePacking<dim>& pixels) const {
    if (!pixels.crop) return {};
    const auto& [left, top, lowest, extents] = *pixels.crop;
    return fmt::format("{} {}, from {} right of the left side and {} below the top{}", fmt::join(extents, " x "),
                       name_of_pixels(dim), left, top, dim == 3 ? fmt::format(" and {} above the lowest", lowest) : "");
  }
  template <class Packing>
  std::string operator()(const Packing&) const {
    return {};
  }
};

}  // namespace

std::vector<std::string> words_on_threshold(const Stage& stage) {
  return visit_nested(WordsOnThreshold{stage}, stage.packing);
}

std::string words_on_sides(const Stage& stage) {
  return stage.fillers.empty() ? "" : visit_nested(WordsOnSides(), stage.packing);
}

std::string words_on_crop(const Stage& stage) {
  return visit_nested(WordsOnCrop(), stage.packing);
}

std::string material_of_label(const Stage& stage, Label label) {
  return label == 0 ? name_of(stage.matrix) : stage.fillers[std::size_t{label} - 1].material.name;
}

}  // namespace breccia

#include "homogenisation/image_warnings.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "breccia/nested_variant.hpp"

#include "homogenisation/narrow_gaps.hpp"
#include "microstructure/image/grey_histogram.hpp"
#include "microstructure/image/image_lines.hpp"
#include "microstructure/image/image_sides.hpp"
#include "microstructure/image/image_statistics.hpp"

namespace breccia {
namespace {

using Warning = std::optional<std::string>;

Warning warning_of_poor_threshold(const GreySegmentation& made) {
  if (made.separability >= separability_of_flat_histogram) return std::nullopt;
  return fmt::format(
      "the threshold {:g} hardly separates the grey values: Otsu's separability is {:.2f}, and that of a "
      "flat histogram {:g}; the two materials are alike in grey, one of them is rare, or the picture is "
      "noisy or unevenly lit: look at microstructure.svg (docs/tutorial-image.md)",
      made.threshold, made.separability, separability_of_flat_histogram);
}

Warning warning_of_frame(const GreySegmentation& made) {
  if (made.frame == 0) return std::nullopt;
  return fmt::format(
      "the outermost {} at a side of the picture {} one grey value throughout, as a frame has, or the "
      "bar below a micrograph: it counts as material; packing.crop leaves it out",
      made.frame == 1 ? std::string("line of pixels") : fmt::format("{} lines of pixels", made.frame),
      made.frame == 1 ? "has" : "have");
}

/// A warning on the opposite sides of an image, which the periodic boundary joins. (What another boundary cuts:
/// stage_warnings.cpp.)
template <int dim>
Warning warning_of_seam(const std::vector<Boundary>& boundaries, const LabelImage<dim>& image) {
  const double cut = 100.0 * cut_share(image);
  const auto seam = seam_of(image);
  if (std::ranges::find(boundaries, Boundary::periodic) == boundaries.end() || seam.fits()) return std::nullopt;
  return fmt::format(
      "opposite sides of the picture do not fit together: {:.0f} % of their pixels differ, and at most "
      "{:.0f} % of those of neighbouring {} inside: the periodic box joins the particles that the sides "
      "cut, {:.0f} % of the filler, to others; the larger the picture, the less that counts",
      100.0 * seam.across, 100.0 * seam.most_inside, dim == 3 ? "layers" : "lines", cut);
}

template <int dim>
Warning warning_of_single_pixels(const LabelImage<dim>& image, const Intercepts& intercepts) {
  constexpr double few = 0.1;
  const double sides = specific_interface(image) * image.pixel_side * static_cast<double>(image.labels.size());
  const double around = 2.0 * dim * static_cast<double>(intercepts.isolated_pixels);
  if (!(around > few * sides)) return std::nullopt;
  return fmt::format(
      "{} single pixels of another material than all around them have {:.0f} % of the interface: noise "
      "of the picture? The medians of packing.smooth = 3 remove it from a grey picture",
      intercepts.isolated_pixels, 100.0 * std::min(around / sides, 1.0));
}

/// The width of a gap [pixels] below which its width is not known well enough for the modulus at long times.
constexpr double known_gap = 3.0;

template <int dim>
Warning warning_of_narrow_gaps(const Study& study, const Stage& stage, const LabelImage<dim>& image,
                               const Intercepts& intercepts, double narrow) {
  constexpr double few = 0.05;
  if (intercepts.gaps == 0 || has_soft_fillers(study, stage)) return std::nullopt;
  const double share = static_cast<double>(intercepts.narrow_gaps) / static_cast<double>(intercepts.gaps);
  if (share < few) return std::nullopt;
  const double cells = narrow * image.pixel_side / stage.side * stage.grids().front();
  return fmt::format(
      "{:.0f} % of the gaps between its filler, along lines of pixels, are narrower than {:.3g} pixels "
      "({:.2g} cells): they decide the modulus at long times, and their width is known to a pixel only; "
      "what touches in the picture is bonded; a picture of a higher magnification shows more",
      100.0 * share, narrow, cells);
}

Warning warning_of_small_particles(const Intercepts& intercepts) {
  constexpr double enough = 8.0;  // discs of ten pixels
  if (!(intercepts.mean_filler < enough) || intercepts.mean_filler == 0.0) return std::nullopt;
  return fmt::format(
      "a line of pixels crosses its filler in {:.2g} pixels on the average; below {:g} the steps of the "
      "pixels are a part of the shape of the particles",
      intercepts.mean_filler, enough);
}

struct WarningsOnImage {
  const Study& study;
  const Stage& stage;

  template <int dim>
  std::vector<std::string> operator()(const ImagePacking<dim>& pixels) const {
    if (!pixels.image || stage.fillers.empty()) return {};
    const auto& image = *pixels.image;
    const double pixels_per_cell = static_cast<double>(image.pixels[0]) / stage.grids().front();
    const double narrow = std::max(known_gap, cells_in_resolved_gaps(study.tests.mixing) * pixels_per_cell);
    const auto intercepts = intercepts_of(image, narrow);
    std::vector<Warning> all;
    if (pixels.segmentation) {
      all = {warning_of_poor_threshold(*pixels.segmentation), warning_of_frame(*pixels.segmentation)};
    }
    all.insert(all.end(), {warning_of_seam(study.tests.boundaries, image), warning_of_single_pixels(image, intercepts),
                           warning_of_small_particles(intercepts),
                           warning_of_narrow_gaps(study, stage, image, intercepts, narrow)});
    std::vector<std::string> warnings;
    for (auto& warning : all) {
      if (warning) warnings.push_back(*std::move(warning));
    }
    return warnings;
  }
  template <class Packing>
  std::vector<std::string> operator()(const Packing&) const {
    return {};
  }
};

}  // namespace

std::vector<std::string> warnings_on_image(const Study& study, const Stage& stage) {
  return visit_nested(WarningsOnImage{study, stage}, stage.packing);
}

}  // namespace breccia

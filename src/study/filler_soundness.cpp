#include "study/filler_soundness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/draw_diameters.hpp"

#include "microstructure/image/image_statistics.hpp"
#include "study/filler_shapes.hpp"
#include "study/filler_sizes.hpp"
#include "study/limits.hpp"
#include "study/listed_box.hpp"
#include "study/material_soundness.hpp"
#include "study/stage_rules.hpp"

namespace breccia {
namespace {

void check_list(const ListedSizes& sizes, const std::string& part, StudyMistakes& mistakes) {
  const auto is_diameter = [](double diameter) { return accepts(Range::positive(), diameter); };
  if (sizes.diameters.empty()) mistakes.add(part, "expected at least one diameter, got an empty list of sizes");
  if (!std::ranges::all_of(sizes.diameters, is_diameter)) mistakes.add(part, "expected positive diameters in the list");
  if (sizes.diameters.size() > most_particles) {
    mistakes.add(part, fmt::format("expected at most {} particles, got {}", most_particles, sizes.diameters.size()));
  }
}

bool has_ordered_cuts(const Filler& filler) {
  return !filler.smallest || !filler.largest || *filler.smallest < *filler.largest;
}

/// Checks the bounds at which a distribution of sizes is cut; other sizes must not have any.
void check_cuts(const Filler& filler, const std::string& part, StudyMistakes& mistakes) {
  const auto ends = ends_of(*filler.sizes);
  if (!ends && (filler.smallest || filler.largest)) {
    mistakes.add(part, "expected no smallest and largest size: only a distribution of sizes is cut");
  }
  if (ends && !((filler.smallest || ends->smallest) && (filler.largest || ends->largest))) {
    mistakes.add(part, "expected a smallest and a largest size: the distribution does not have both ends of its own");
  }
  const auto check_cut = [&](const char* what, std::optional<double> cut) {
    if (cut) mistakes.check_quantity(part, what, *cut, Range::positive(), Dimension::length);
  };
  check_cut("smallest size", filler.smallest);
  check_cut("largest size", filler.largest);
  if (!has_ordered_cuts(filler)) mistakes.add(part, "expected a smallest size below the largest size");
}

/// Checks that a filler has the sizes and the fraction that a packing needs which draws or arranges particles.
void check_amount(const Filler& filler, PackingName packing, const std::string& part, StudyMistakes& mistakes) {
  if (packing == PackingName::regular) {
    if (!std::holds_alternative<SingleSize>(*filler.sizes)) {
      mistakes.add(part, "expected a single size for a regular packing");
    }
    if (filler.fraction) mistakes.add(part, "expected no fraction: that of a regular packing follows from its size");
  } else if (std::holds_alternative<ListedSizes>(*filler.sizes)) {
    if (filler.fraction) mistakes.add(part, "expected no fraction: that of a list of sizes follows from the list");
  } else if (!filler.fraction) {
    mistakes.add(part, "expected a fraction for a random packing");
  } else {
    mistakes.check_number(part, "fraction", *filler.fraction, allowed::fraction);
  }
}

void check_sizes(const Filler& filler, PackingName packing, const std::string& part, StudyMistakes& mistakes) {
  if (!filler.sizes) {
    mistakes.add(part, "expected sizes; only an explicit packing has none");
    return;
  }
  check_amount(filler, packing, part, mistakes);
  check_cuts(filler, part, mistakes);
  if (const auto* listed = std::get_if<ListedSizes>(&*filler.sizes)) {
    check_list(*listed, part, mistakes);
  } else if (has_ordered_cuts(filler)) {
    mistakes.add_error_of(part, [&filler] { static_cast<void>(distribution_of(filler)); });
  }
}

void check_no_sizes(const Filler& filler, const std::string& part, StudyMistakes& mistakes) {
  if (filler.sizes || filler.fraction || filler.smallest || filler.largest) {
    mistakes.add(part, "expected neither sizes nor a fraction: the particles of an explicit packing are all listed");
  }
}

void check_gap(const Filler& filler, const Stage& stage, const std::string& part, StudyMistakes& mistakes) {
  mistakes.check_quantity(part, "gap", filler.gap, Range::not_negative(), Dimension::length);
  if (!stage.is_random() && filler.gap > 0.0) {
    mistakes.add(part, "expected no gap: only a random packing keeps one");
  }
}

void check_shape(const Filler& filler, const Stage& stage, const std::string& part, StudyMistakes& mistakes) {
  if (!filler.shape) return;
  if (stage.packing_name() != PackingName::random_sequential) {
    mistakes.add(part, "expected no shape: only a random sequential packing places other shapes than discs");
  }
  mistakes.add_all(part, mistakes_of_shape(*filler.shape));
  const bool is_of_space = std::holds_alternative<EllipticOutline>(filler.shape->outline) && !filler.shape->angle;
  if (stage.dimensions() == 3 && !is_of_space) {
    mistakes.add(part, "expected ellipsoids without an angle in a box of three dimensions");
  }
}

/// Checks the sizes and the fraction of grains that fill the box.
template <int dim>
void check_grains(const Filler& filler, const LaguerrePacking<dim>& grains, const std::string& part,
                  StudyMistakes& mistakes) {
  if (filler.coating) mistakes.add(part, "expected no coating: grains have films alone");
  if (grains.film) mistakes.check_quantity(part, "film", *grains.film, Range::positive(), Dimension::length);
  if (filler.fraction.has_value() == grains.film.has_value()) {
    mistakes.add(part, "expected either the fraction of the grains or the thickness of the film between them");
  }
  if (filler.fraction) mistakes.check_number(part, "fraction", *filler.fraction, allowed::fraction);
  if (grains.is_random()) {
    if (!filler.sizes) {
      mistakes.add(part, "expected sizes or sites");
      return;
    }
    check_cuts(filler, part, mistakes);
    if (const auto* listed = std::get_if<ListedSizes>(&*filler.sizes)) {
      check_list(*listed, part, mistakes);
    } else if (has_ordered_cuts(filler)) {
      mistakes.add_error_of(part, [&filler] { static_cast<void>(distribution_of(filler)); });
    }
  } else if (filler.sizes || filler.smallest || filler.largest) {
    mistakes.add(part, "expected no sizes: those of the grains follow from their sites");
  }
}

void refuse_several_fillers(const Stage& stage, const char* packing, const std::string& part, StudyMistakes& mistakes) {
  if (stage.fillers.size() < 2) return;
  mistakes.add(part, fmt::format("expected one filler for a {}, got {}", packing, stage.fillers.size()));
}

template <int dim>
void check_sites(const Stage& stage, const LaguerrePacking<dim>& grains, const std::string& part,
                 StudyMistakes& mistakes) {
  refuse_several_fillers(stage, "tessellation", part, mistakes);
  if (grains.is_random() || !accepts(allowed::side, stage.side)) return;
  const LaguerreSites<dim> listed = {stage.side, grains.walls, grains.sites, grains.wall_film, grains.film_shares};
  if (!listed.film_shares.empty() && listed.film_shares.size() != listed.sites.size()) {
    mistakes.add(part, fmt::format("expected a share of the films for each of {} sites, or none, got {}",
                                   listed.sites.size(), listed.film_shares.size()));
    return;
  }
  for (const auto& [site, text] : breccia::mistakes(listed)) {
    mistakes.add(part, fmt::format("site {}: {}", site + 1, text));
  }
}

/// Checks a filler whose pixels are labelled.
void check_labelled(const Filler& filler, const std::string& part, StudyMistakes& mistakes) {
  if (filler.sizes || filler.fraction || filler.smallest || filler.largest) {
    mistakes.add(part, "expected neither sizes nor a fraction: both follow from the image");
  }
  if (filler.coating) mistakes.add(part, "expected no coating: in an image it is a filler with a label of its own");
}

template <int dim>
void check_image(const Stage& stage, const SharedImage<dim>& image, const std::string& part, StudyMistakes& mistakes) {
  if (!image) {
    mistakes.add(part, dim == 3 ? "expected a stack of images" : "expected an image");
    return;
  }
  mistakes.add_error_of(part, [&] {
    require_valid(*image);
    static_cast<void>(label_fractions(*image, stage.fillers.size() + 1));
    if (!has_equal_sides(*image)) {
      throw InputError(fmt::format("expected a {} image, got {} pixels", dim == 3 ? "cubic" : "square",
                                   fmt::join(image->pixels, " x ")));
    }
    constexpr double rounding = 1e-9;
    if (!(std::abs(box_of(*image)[0] / stage.side - 1.0) <= rounding)) {
      throw InputError(fmt::format("expected {} pixels that fill the box of {} m, got a side of {} m", image->pixels[0],
                                   stage.side, box_of(*image)[0]));
    }
  });
}

/// Checks whether a filler has the sizes and the fraction that its packing needs: a visitor of the packing.
struct CheckAmount {
  const Filler& filler;
  const Stage& stage;
  const std::string& part;
  StudyMistakes& mistakes;

  template <int dim>
  void operator()(const LaguerrePacking<dim>& grains) const {
    check_grains(filler, grains, part, mistakes);
  }
  template <int dim>
  void operator()(const ImagePacking<dim>&) const {
    check_labelled(filler, part, mistakes);
  }
  template <int dim>
  void operator()(const ExplicitPacking<dim>&) const {
    check_no_sizes(filler, part, mistakes);
  }
  template <class Packing>
  void operator()(const Packing&) const {
    check_sizes(filler, Packing::name, part, mistakes);
    if (!accepts(allowed::side, stage.side)) return;  // a mistake of the stage
    mistakes.add_all(part, mistakes_of_gap(filler, stage.side));
    mistakes.add_all(part, mistakes_of_diameters(filler, stage.packing, stage.side));
  }
};

void check_filler(const Filler& filler, const Stage& stage, const std::string& part, StudyMistakes& mistakes) {
  if (filler.material != void_material()) check_material(filler.material, part, mistakes);
  if (filler.coating) {
    check_material(filler.coating->material, part + ", coating", mistakes);
    mistakes.check_quantity(part, "thickness of the coating", filler.coating->thickness, Range::positive(),
                            Dimension::length);
  }
  check_gap(filler, stage, part, mistakes);
  check_shape(filler, stage, part, mistakes);
  visit_nested(CheckAmount{filler, stage, part, mistakes}, stage.packing);
}

template <int dim>
void check_listed(const Stage& stage, const ExplicitPacking<dim>& listed, const std::string& part,
                  StudyMistakes& mistakes) {
  const auto count = listed.count();
  const auto& fillers = listed.fillers;
  if (count == 0) mistakes.add(part, "expected at least one particle");
  if (!fillers.empty() && fillers.size() != count) {
    mistakes.add(part, fmt::format("expected the filler of each of {} particles, got {}", count, fillers.size()));
    return;
  }
  if (fillers.empty() && stage.fillers.size() > 1) {
    mistakes.add(part, "expected the filler of each particle, since there are several");
  }
  const auto is_unknown = [&](std::size_t filler) { return filler >= stage.fillers.size(); };
  if (const auto unknown = std::ranges::find_if(fillers, is_unknown); unknown != fillers.end()) {
    mistakes.add(part, fmt::format("a particle is of filler {}, counted from 0, but there are only {}", *unknown,
                                   stage.fillers.size()));
    return;
  }
  if (!accepts(allowed::side, stage.side)) return;  // a mistake of the stage
  mistakes.add_error_of(part, [&] { require_room<dim>(stage, listed_box(stage, listed)); });
}

/// Checks the settings of a packing.
struct CheckPacking {
  const Stage& stage;
  const std::string& part;
  StudyMistakes& mistakes;

  template <int dim>
  void operator()(const ExplicitPacking<dim>& listed) const {
    check_listed(stage, listed, part, mistakes);
  }
  template <int dim>
  void operator()(const LaguerrePacking<dim>& grains) const {
    check_sites(stage, grains, part, mistakes);
  }
  void operator()(const RegularPacking& regular) const {
    mistakes.check_integer(part, "columns", regular.columns, allowed::rows);
    mistakes.check_integer(part, "rows", regular.rows, allowed::rows);
    refuse_several_fillers(stage, "regular packing", part, mistakes);
  }
  void operator()(const LatticePacking& cubic) const {
    mistakes.check_integer(part, "repeats", cubic.repeats, allowed::repeats);
    refuse_several_fillers(stage, "regular packing", part, mistakes);
  }
  /// All walls and seeds are allowed. An image is checked even where a stage has no filler.
  template <class Packing>
  void operator()(const Packing&) const {}
};

struct CheckImage {
  const Stage& stage;
  const std::string& part;
  StudyMistakes& mistakes;

  template <int dim>
  void operator()(const ImagePacking<dim>& pixels) const {
    check_image(stage, pixels.image, part, mistakes);
  }
  template <class Packing>
  void operator()(const Packing&) const {}
};

}  // namespace

void check_fillers(const Stage& stage, const std::string& part, StudyMistakes& mistakes) {
  visit_nested(CheckImage{stage, part + ", packing", mistakes}, stage.packing);
  if (stage.fillers.empty()) return;
  if (stage.fillers.size() > allowed::most_fillers) {
    mistakes.add(part, fmt::format("expected at most {} fillers, got {}", allowed::most_fillers, stage.fillers.size()));
  }
  const bool are_several = stage.fillers.size() > 1;
  for (std::size_t number = 0; number < stage.fillers.size(); ++number) {
    const auto place = are_several ? fmt::format("{}, filler {}", part, number) : part + ", filler";
    check_filler(stage.fillers[number], stage, place, mistakes);
  }
  mistakes.add_all(part, mistakes_of_fractions(stage));
  mistakes.add_all(part, mistakes_of_phases(stage));
  const auto packing = part + (are_several ? ", packing" : ", filler");
  visit_nested(CheckPacking{stage, packing, mistakes}, stage.packing);
}

}  // namespace breccia

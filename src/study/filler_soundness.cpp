#include "filler_soundness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/draw_diameters.hpp"
#include "breccia/microstructure/image_statistics.hpp"
#include "breccia/microstructure/particle_validity.hpp"
#include "breccia/microstructure/validity.hpp"
#include "breccia/study/coatings.hpp"
#include "breccia/study/filler_shapes.hpp"
#include "breccia/study/filler_sizes.hpp"
#include "breccia/study/limits.hpp"
#include "breccia/study/stage_rules.hpp"

#include "material_soundness.hpp"

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

/// The bounds at which a distribution of sizes is cut; nothing else has any.
void check_cuts(const Filler& filler, const std::string& part, StudyMistakes& mistakes) {
  const bool is_lognormal = std::holds_alternative<LognormalSizes>(*filler.sizes);
  const bool is_distribution = is_lognormal || std::holds_alternative<TabulatedSizes>(*filler.sizes);
  if (!is_distribution && (filler.smallest || filler.largest)) {
    mistakes.add(part, "expected no smallest and largest size: only a distribution of sizes is cut");
  }
  if (is_lognormal && !(filler.smallest && filler.largest)) {
    mistakes.add(part, "expected a smallest and a largest size: a lognormal distribution has no ends of its own");
  }
  const auto check_cut = [&](const char* what, std::optional<double> cut) {
    if (cut) mistakes.check_quantity(part, what, *cut, Range::positive(), Dimension::length);
  };
  check_cut("smallest size", filler.smallest);
  check_cut("largest size", filler.largest);
  if (!has_ordered_cuts(filler)) mistakes.add(part, "expected a smallest size below the largest size");
}

/// Which of sizes and fraction go with a packing that draws or arranges particles.
void check_amount(const Filler& filler, const PackingMethod& packing, const std::string& part,
                  StudyMistakes& mistakes) {
  if (std::holds_alternative<RegularPacking>(packing) || std::holds_alternative<LatticePacking>(packing)) {
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

void check_sizes(const Filler& filler, const PackingMethod& packing, const std::string& part, StudyMistakes& mistakes) {
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
  if (!std::holds_alternative<RandomSequentialPacking>(stage.packing)) {
    mistakes.add(part, "expected no shape: only a random sequential packing places other shapes than discs");
  }
  mistakes.add_all(part, mistakes_of_shape(*filler.shape));
  const bool is_of_space = std::holds_alternative<EllipticOutline>(filler.shape->outline) && !filler.shape->angle;
  if (stage.dimensions == 3 && !is_of_space) {
    mistakes.add(part, "expected ellipsoids without an angle in a box of three dimensions");
  }
}

/// The sizes and the fraction of grains that fill the box.
void check_grains(const Filler& filler, const LaguerrePacking& grains, const std::string& part,
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

template <int dim>
void check_sites_in(const Stage& stage, const std::string& part, StudyMistakes& mistakes) {
  const auto& grains = *stage.grains();
  const auto& sites = grains.sites_in<dim>();
  if (sites.size() != grains.site_count()) {
    mistakes.add(part, fmt::format("expected sites of {} coordinates in a box of {} dimensions", dim, dim));
    return;
  }
  const LaguerreSites<dim> listed = {stage.side, grains.walls, sites, grains.wall_film, grains.film_shares};
  if (!listed.film_shares.empty() && listed.film_shares.size() != sites.size()) {
    mistakes.add(part, fmt::format("expected a share of the films for each of {} sites, or none, got {}", sites.size(),
                                   listed.film_shares.size()));
    return;
  }
  for (const auto& [site, text] : breccia::mistakes(listed)) {
    mistakes.add(part, fmt::format("site {}: {}", site + 1, text));
  }
}

void check_sites(const Stage& stage, const std::string& part, StudyMistakes& mistakes) {
  if (stage.fillers.size() > 1) {
    mistakes.add(part, fmt::format("expected one filler for a tessellation, got {}", stage.fillers.size()));
  }
  if (stage.grains()->is_random() || !accepts(allowed::side, stage.side)) return;
  if (stage.dimensions == 3) {
    check_sites_in<3>(stage, part, mistakes);
  } else {
    check_sites_in<2>(stage, part, mistakes);
  }
}

/// A filler whose pixels are labelled.
void check_labelled(const Filler& filler, const std::string& part, StudyMistakes& mistakes) {
  if (filler.sizes || filler.fraction || filler.smallest || filler.largest) {
    mistakes.add(part, "expected neither sizes nor a fraction: both follow from the image");
  }
  if (filler.coating) mistakes.add(part, "expected no coating: in an image it is a filler with a label of its own");
}

template <int dim>
void check_image_in(const Stage& stage, const LabelImage<dim>* image, const std::string& part,
                    StudyMistakes& mistakes) {
  if (image == nullptr) {
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

void check_image(const Stage& stage, const std::string& part, StudyMistakes& mistakes) {
  if (stage.dimensions == 3) {
    check_image_in(stage, stage.stack(), part, mistakes);
  } else {
    check_image_in(stage, stage.image(), part, mistakes);
  }
}

void check_filler(const Filler& filler, const Stage& stage, const std::string& part, StudyMistakes& mistakes) {
  check_material(filler.material, part, mistakes);
  if (filler.coating) {
    check_material(filler.coating->material, part + ", coating", mistakes);
    mistakes.check_quantity(part, "thickness of the coating", filler.coating->thickness, Range::positive(),
                            Dimension::length);
  }
  check_gap(filler, stage, part, mistakes);
  check_shape(filler, stage, part, mistakes);
  if (const auto* grains = stage.grains()) {
    check_grains(filler, *grains, part, mistakes);
    return;
  }
  if (std::holds_alternative<ImagePacking>(stage.packing)) {
    check_labelled(filler, part, mistakes);
    return;
  }
  if (stage.listed() != nullptr) {
    check_no_sizes(filler, part, mistakes);
    return;
  }
  check_sizes(filler, stage.packing, part, mistakes);
  if (!accepts(allowed::side, stage.side)) return;  // a mistake of the stage
  mistakes.add_all(part, mistakes_of_gap(filler, stage.side));
  mistakes.add_all(part, mistakes_of_diameters(filler, stage.packing, stage.side));
}

void check_listed_particles(const Stage& stage, const std::string& part, StudyMistakes& mistakes) {
  const auto& [file, discs, walls, fillers, particles, spheres, ellipsoids] = *stage.listed();
  const auto count = discs.size() + particles.size() + spheres.size() + ellipsoids.size();
  if (count == 0) mistakes.add(part, "expected at least one particle");
  if (std::max({discs.size(), particles.size(), spheres.size(), ellipsoids.size()}) < count) {
    mistakes.add(part, "expected discs, or particles of other shapes, or spheres, and nothing beside them");
    return;
  }
  if (spheres.size() + ellipsoids.size() != (stage.dimensions == 3 ? count : 0)) {
    mistakes.add(part, "expected spheres or ellipsoids in a box of three dimensions, and none in one of two");
    return;
  }
  if (!fillers.empty() && fillers.size() != count) {
    mistakes.add(part, fmt::format("expected the filler of each of {} particles, got {}", count, fillers.size()));
    return;
  }
  if (fillers.empty() && stage.fillers.size() > 1) {
    mistakes.add(part, "expected the filler of each disc, since there are several");
  }
  const auto is_unknown = [&](std::size_t filler) { return filler >= stage.fillers.size(); };
  if (const auto unknown = std::ranges::find_if(fillers, is_unknown); unknown != fillers.end()) {
    mistakes.add(part, fmt::format("a particle is of filler {}, counted from 0, but there are only {}", *unknown,
                                   stage.fillers.size()));
    return;
  }
  if (!accepts(allowed::side, stage.side)) return;  // a mistake of the stage
  mistakes.add_error_of(part, [&, &walls = walls, &discs = discs, &fillers = fillers, &particles = particles,
                               &spheres = spheres, &ellipsoids = ellipsoids] {
    if (!ellipsoids.empty()) {
      require_valid(ellipsoid_box(stage, *stage.listed()));
    } else if (!spheres.empty()) {
      require_valid(with_coatings<3>(stage, {stage.side, walls, spheres, fillers}));
    } else if (!particles.empty()) {
      require_valid(particle_box(stage, *stage.listed()));
    } else {
      require_valid<2>(with_coatings<2>(stage, {stage.side, walls, discs, fillers}));
    }
  });
}

}  // namespace

void check_fillers(const Stage& stage, const std::string& part, StudyMistakes& mistakes) {
  if (std::holds_alternative<ImagePacking>(stage.packing)) check_image(stage, part + ", packing", mistakes);
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
  if (stage.listed() != nullptr) check_listed_particles(stage, packing, mistakes);
  if (stage.grains() != nullptr) check_sites(stage, packing, mistakes);
  const auto* regular = std::get_if<RegularPacking>(&stage.packing);
  const auto* cubic = std::get_if<LatticePacking>(&stage.packing);
  if (regular != nullptr) {
    mistakes.check_integer(packing, "columns", regular->columns, allowed::rows);
    mistakes.check_integer(packing, "rows", regular->rows, allowed::rows);
  }
  if (cubic != nullptr) mistakes.check_integer(packing, "repeats", cubic->repeats, allowed::repeats);
  if (regular != nullptr || cubic != nullptr) {
    if (are_several) {
      mistakes.add(packing, fmt::format("expected one filler for a regular packing, got {}", stage.fillers.size()));
    }
  }
}

}  // namespace breccia

#include "sound_study.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace breccia::fuzz {

namespace {

void require(bool is_so, const std::string& what) {
  if (!is_so) throw std::logic_error("accepted without " + what);
}

bool is_positive(double value) {
  return value > 0.0 && std::isfinite(value);
}

void require_sound(const PronySeries& series) {
  require(is_positive(series.unrelaxed()), "a positive modulus");
  for (const auto& [relaxation_time, modulus] : series.terms()) {
    require(is_positive(relaxation_time), "positive relaxation times");
    require(modulus >= 0.0, "moduli that are not negative");
  }
}

void require_sound(const Material& material) {
  require(is_positive(material.density), "a positive density");
  require_sound(material.bulk);
  require_sound(material.shear);
}

struct RequireSizes {
  void operator()(const SingleSize& sizes) const { require(is_positive(sizes.diameter), "a diameter"); }
  void operator()(const ListedSizes& sizes) const {
    require(!sizes.diameters.empty(), "sizes in the list");
    for (const double diameter : sizes.diameters) require(is_positive(diameter), "positive diameters in the list");
  }
  void operator()(const LognormalSizes& sizes) const {
    require(!sizes.components.empty(), "components of the distribution");
    for (const auto& [weight, median, sigma] : sizes.components) {
      require(is_positive(weight) && weight <= 1.0, "weights of the components");
      require(is_positive(median) && is_positive(sigma), "a median and a width of the components");
    }
  }
  void operator()(const TabulatedSizes& sizes) const {
    require(sizes.diameters.size() >= 2 && is_positive(sizes.diameters.front()), "diameters in the table");
  }
  void operator()(const FullerSizes& sizes) const {
    require(is_positive(sizes.largest) && is_positive(sizes.exponent), "numbers of Fuller's curve");
  }
  void operator()(const RosinRammlerSizes& sizes) const {
    require(is_positive(sizes.size) && is_positive(sizes.exponent), "numbers of Rosin and Rammler");
  }
  void operator()(const QuantileSizes& sizes) const {
    require(is_positive(sizes.d10) && sizes.d10 < sizes.d50 && sizes.d50 < sizes.d90, "rising quantiles");
  }
};

void require_sound(const Filler& filler) {
  if (filler.material != void_material()) require_sound(filler.material);
  if (filler.fraction) require(*filler.fraction > 0.0 && *filler.fraction < 1.0, "a fraction between 0 and 1");
  if (filler.smallest) require(*filler.smallest < *filler.largest, "sizes from the smallest to the largest");
  if (filler.sizes) std::visit(RequireSizes(), *filler.sizes);
  require(filler.gap >= 0.0 && std::isfinite(filler.gap), "a gap");
  if (!filler.coating) return;
  require_sound(filler.coating->material);
  require(is_positive(filler.coating->thickness), "a thickness of the coating");
}

/// The packing of a stage.
struct RequirePacking {
  const Stage& stage;

  template <int dim>
  void operator()(const ExplicitPacking<dim>& listed) const {
    if (stage.fillers.empty()) return;
    require(listed.count() > 0, "particles");
    const auto* const balls = std::get_if<std::vector<Ball<dim>>>(&listed.particles);
    for (const auto& ball : balls == nullptr ? std::vector<Ball<dim>>() : *balls) {
      require(is_positive(ball.diameter) && ball.diameter <= stage.side, "diameters within the box");
    }
  }
  template <int dim>
  void operator()(const LaguerrePacking<dim>& grains) const {
    if (stage.fillers.empty()) return;
    if (grains.film) require(is_positive(*grains.film), "a thickness of the films");
    for (const auto& site : grains.sites) require(std::isfinite(site.weight), "weights of the sites");
  }
  template <int dim>
  void operator()(const ImagePacking<dim>& packing) const {
    const auto& image = *packing.image;
    std::size_t pixels = 1;
    for (const int along : image.pixels) pixels *= static_cast<std::size_t>(along);
    require(has_equal_sides(image) && image.labels.size() == pixels, "a square of pixels or a cube of voxels");
    require(std::ranges::max(image.labels) <= stage.fillers.size(), "fillers of the labels");
  }
  template <class Packing>
  void operator()(const Packing&) const {}
};

void require_sound(const Stage& stage) {
  require(!stage.name.empty() && stage.name.find_first_of("/\\") == std::string::npos, "a name for its directory");
  if (const auto* matrix = std::get_if<Material>(&stage.matrix)) require_sound(*matrix);
  require(is_positive(stage.side) && is_positive(stage.side * stage.side), "an area of the box");
  require(stage.cells >= 2 && is_positive(stage.cell_size()), "cells");
  for (const auto& filler : stage.fillers) require_sound(filler);
  visit_nested(RequirePacking{stage}, stage.packing);
}

}  // namespace

void require_sound(const Study& study) {
  for (const auto& [material, shift, constants, expansion] : study.materials) {
    require_sound(material);
    require(!expansion || std::isfinite(*expansion), "a finite thermal expansion");
  }
  require(!study.stages.empty(), "stages");
  for (const auto& stage : study.stages) require_sound(stage);
  const auto& tests = study.tests;
  require(!tests.loads.empty() && !tests.boundaries.empty() && !tests.methods.empty(), "tests");
  require(is_positive(tests.first_time) && is_positive(tests.last_time) && tests.first_time < tests.last_time, "times");
  require(tests.points_per_decade > 0, "points of the curves");
  for (const double time : tests.field_times) {
    require(time >= tests.first_time && time <= tests.last_time, "times of fields within those of the tests");
  }
  for (const auto& measurement : study.measurements) {
    const auto known = measurement.known_within({tests.first_time, tests.last_time});
    if (known) require(is_positive(measurement.at(known->begin)), "a measured modulus");
  }
}

}  // namespace breccia::fuzz

#include "study/filler_sizes.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace breccia {

namespace {

struct DistributionOf {
  using Answer = std::optional<SizeDistribution>;

  Answer operator()(const SingleSize& sizes) const { return SizeDistribution::monodisperse(sizes.diameter); }
  Answer operator()(const ListedSizes&) const { return std::nullopt; }
  Answer operator()(const LognormalSizes& sizes) const {
    std::vector<LognormalComponent> components;
    for (const auto& [weight, median, sigma] : sizes.components) components.push_back({weight, median, sigma});
    return SizeDistribution::lognormal_mixture(std::move(components));
  }
  Answer operator()(const TabulatedSizes& sizes) const {
    return SizeDistribution::tabulated(sizes.diameters, sizes.cumulative_volume_fractions);
  }
  Answer operator()(const FullerSizes& sizes) const { return SizeDistribution::fuller(sizes); }
  Answer operator()(const RosinRammlerSizes& sizes) const { return SizeDistribution::rosin_rammler(sizes); }
  Answer operator()(const QuantileSizes& sizes) const { return SizeDistribution::quantiles(sizes); }
};

struct EndsOf {
  using Answer = std::optional<SizeEnds>;

  Answer operator()(const SingleSize&) const { return std::nullopt; }
  Answer operator()(const ListedSizes&) const { return std::nullopt; }
  Answer operator()(const TabulatedSizes& sizes) const {
    if (sizes.diameters.empty()) return SizeEnds();
    return SizeEnds{sizes.diameters.front(), sizes.diameters.back()};
  }
  Answer operator()(const FullerSizes& sizes) const { return SizeEnds{std::nullopt, sizes.largest}; }
  /// The other laws go on without end.
  template <class Law>
  Answer operator()(const Law&) const {
    return SizeEnds();
  }
};

struct DiametersOf {
  using Answer = std::optional<DiameterRange>;
  const Filler& filler;

  Answer operator()(const SingleSize& sizes) const { return DiameterRange{sizes.diameter, sizes.diameter}; }
  Answer operator()(const ListedSizes& sizes) const {
    if (sizes.diameters.empty()) return std::nullopt;
    const auto [smallest, largest] = std::ranges::minmax(sizes.diameters);
    return DiameterRange{smallest, largest};
  }
  template <class Distribution>
  Answer operator()(const Distribution& sizes) const {
    const auto ends = *EndsOf()(sizes);
    const auto smallest = filler.smallest ? filler.smallest : ends.smallest;
    const auto largest = filler.largest ? filler.largest : ends.largest;
    if (!smallest || !largest) return std::nullopt;
    return DiameterRange{std::max(*smallest, ends.smallest.value_or(*smallest)),
                         std::min(*largest, ends.largest.value_or(*largest))};
  }
};

double diameter_of(const Particle& particle) {
  return equivalent_diameter(particle.shape);
}
double diameter_of(const Ellipsoid& ellipsoid) {
  return equivalent_diameter(ellipsoid);
}
template <int dim>
double diameter_of(const Ball<dim>& ball) {
  return ball.diameter;
}

/// The range of the diameters of listed particles; nothing for other packings.
struct ListedDiameters {
  template <int dim>
  std::optional<DiameterRange> operator()(const ExplicitPacking<dim>& listed) const {
    if (listed.count() == 0) return std::nullopt;
    return std::visit(
        [](const auto& particles) {
          const auto size = [](const auto& particle) { return diameter_of(particle); };
          const auto [smallest, largest] = std::ranges::minmax(particles, {}, size);
          return DiameterRange{size(smallest), size(largest)};
        },
        listed.particles);
  }
  template <class Packing>
  std::optional<DiameterRange> operator()(const Packing&) const {
    return std::nullopt;
  }
};

}  // namespace

std::optional<SizeEnds> ends_of(const Sizes& sizes) {
  return std::visit(EndsOf(), sizes);
}

std::optional<DiameterRange> diameters_of(const Filler& filler) {
  return filler.sizes ? std::visit(DiametersOf{filler}, *filler.sizes) : std::nullopt;
}

std::optional<DiameterRange> diameters_of(const Stage& stage) {
  if (stage.fillers.empty()) return std::nullopt;
  if (stage.is_listed()) return visit_nested(ListedDiameters(), stage.packing);
  std::optional<DiameterRange> all;
  for (const auto& filler : stage.fillers) {
    const auto own = diameters_of(filler);
    if (!own) continue;
    if (!all) all = own;
    all = DiameterRange{std::min(all->smallest, own->smallest), std::max(all->largest, own->largest)};
  }
  return all;
}

std::optional<SizeDistribution> distribution_of(const Filler& filler) {
  if (!filler.sizes) return std::nullopt;
  auto distribution = std::visit(DistributionOf(), *filler.sizes);
  if (distribution && (filler.smallest || filler.largest)) {
    distribution = distribution->truncated(filler.smallest.value_or(distribution->smallest()),
                                           filler.largest.value_or(distribution->largest()));
  }
  return distribution;
}

std::optional<double> fraction_asked_of(const Stage& stage) {
  std::optional<double> fraction;
  for (const auto& filler : stage.fillers) {
    if (!filler.fraction) return std::nullopt;
    fraction = fraction.value_or(0.0) + *filler.fraction;
  }
  return fraction;
}

}  // namespace breccia

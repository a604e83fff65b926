#include "filler_sizes.hpp"

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
};

}  // namespace

std::optional<SizeDistribution> distribution_of(const Filler& filler) {
  if (!filler.sizes) return std::nullopt;
  auto distribution = std::visit(DistributionOf(), *filler.sizes);
  if (distribution && (filler.smallest || filler.largest)) {
    distribution = distribution->truncated(filler.smallest.value_or(distribution->smallest()),
                                           filler.largest.value_or(distribution->largest()));
  }
  return distribution;
}

}  // namespace breccia

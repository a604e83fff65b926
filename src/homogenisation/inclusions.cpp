#include "homogenisation/inclusions.hpp"

#include <algorithm>
#include <cstddef>

namespace breccia {

std::vector<Inclusion> inclusions_of(const Stage& stage, const std::vector<FillerStatistics>& fillers) {
  std::vector<Inclusion> inclusions;
  for (std::size_t number = 0; number < std::min(stage.fillers.size(), fillers.size()); ++number) {
    const auto& filler = stage.fillers[number];
    inclusions.push_back({&filler.material, fillers[number].fraction, false});
    if (filler.coating) inclusions.push_back({&filler.coating->material, fillers[number].coating_fraction, true});
  }
  return inclusions;
}

double fraction_of(const std::vector<Inclusion>& inclusions) {
  double fraction = 0.0;
  for (const auto& inclusion : inclusions) fraction += inclusion.fraction;
  return fraction;
}

double density_with(const std::vector<Inclusion>& inclusions, double matrix) {
  double density = (1.0 - fraction_of(inclusions)) * matrix;
  for (const auto& inclusion : inclusions) density += inclusion.fraction * inclusion.material->density;
  return density;
}

double mean_density(const std::vector<Inclusion>& inclusions) {
  if (inclusions.empty()) return 0.0;
  if (inclusions.size() == 1) return inclusions.front().material->density;
  double mass = 0.0;
  for (const auto& inclusion : inclusions) mass += inclusion.fraction * inclusion.material->density;
  const double fraction = fraction_of(inclusions);
  return fraction > 0.0 ? mass / fraction : 0.0;
}

}  // namespace breccia

#include "breccia/homogenisation/expected_snapshots.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

double factor_of(const std::optional<ModulusInterval>& interval) {
  constexpr double per_decade = 0.7;
  return interval ? 1.0 + per_decade * std::log10(interval->most / interval->least) : 1.0;
}

}  // namespace

double expected_snapshots(const Tests& tests, const Stage& stage) {
  double snapshots = tests.quasistatic.range == SampledRange::matrix ? 11.0 : 9.0;
  // The bases of cubes have been smaller than those of squares.
  constexpr double of_cubes = 0.75;
  if (stage.dimensions() == 3) snapshots *= of_cubes;
  for (const auto& material : named_materials(stage)) {
    const auto varied = std::ranges::find(tests.varied, material.name, &VariedMaterial::name);
    if (varied != tests.varied.end()) snapshots *= factor_of(varied->shear) * factor_of(varied->bulk);
  }
  return snapshots;
}

}  // namespace breccia

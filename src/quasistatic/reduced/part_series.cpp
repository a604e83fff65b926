#include "quasistatic/reduced/part_series.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia::quasistatic {

std::vector<const PronySeries*> series_of_parts(const ReducedResponse& response, std::span<const Material> of_phases) {
  const auto names = response.phases();
  if (of_phases.size() != names.size()) {
    throw InputError(
        fmt::format("reduced response: expected materials of {} phases, got {}", names.size(), of_phases.size()));
  }
  std::vector<const PronySeries*> series;
  for (const auto& [parameter, stiffness] : response.parts) {
    const auto index = std::ranges::find(names, parameter.phase) - names.begin();
    const auto& material = of_phases[static_cast<std::size_t>(index)];
    series.push_back(parameter.modulus == ElasticModulus::shear ? &material.shear : &material.bulk);
  }
  return series;
}

}  // namespace breccia::quasistatic

#include "homogenisation/anisotropy.hpp"

#include <algorithm>

namespace breccia {
namespace {

/// The distance at a time of the shears beside an isotropic mean.
AnisotropyAtTime at_time(int dimensions, const TestResult& mean, const std::vector<TestResult>& tests, double time) {
  std::vector<double> moduli;
  for (const auto load : isotropic_shears(dimensions)) {
    const auto& shear = preferred_test(tests, load, mean.id.boundary, mean.id.method);
    moduli.push_back(smoothed_at(shear.modulus, time));
  }
  const auto [least, most] = std::ranges::minmax(moduli);
  return {time, most / least - 1.0};
}

}  // namespace

std::optional<Anisotropy> anisotropy_of_tests(int dimensions, const std::vector<TestResult>& tests) {
  std::optional<Anisotropy> largest;
  for (const auto& mean : tests) {
    const bool is_preferred = mean.id.load.is_isotropic() && !mean.modulus.empty() &&
                              find_preferred_test(tests, mean.id.load, mean.id.boundary, mean.id.method) == &mean;
    if (!is_preferred) continue;
    const auto first = at_time(dimensions, mean, tests, mean.modulus.front().time);
    const auto last = at_time(dimensions, mean, tests, mean.modulus.back().time);
    if (!largest) largest = Anisotropy{first, last};
    if (first.distance > largest->first.distance) largest->first = first;
    if (last.distance > largest->last.distance) largest->last = last;
  }
  return largest;
}

}  // namespace breccia

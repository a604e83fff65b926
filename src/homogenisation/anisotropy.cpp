#include "homogenisation/anisotropy.hpp"

#include <algorithm>

#include "homogenisation/largest_errors.hpp"
#include "homogenisation/run/isotropic_mean.hpp"

namespace breccia {
namespace {

/// The distance of the shears at a time; nothing where one of them has no modulus any more.
std::optional<AnisotropyAtTime> at_time(const std::vector<const TestResult*>& shears, double time) {
  std::vector<double> moduli;
  moduli.reserve(shears.size());
  for (const auto* shear : shears) moduli.push_back(smoothed_at(shear->modulus, time));
  const auto [least, most] = std::ranges::minmax(moduli);
  return least > 0.0 ? std::optional(AnisotropyAtTime{time, most / least - 1.0}) : std::nullopt;
}

}  // namespace

std::optional<Anisotropy> anisotropy_of_tests(int dimensions, const std::vector<TestResult>& tests) {
  std::optional<Anisotropy> largest;
  for (const auto& mean : tests) {
    const bool is_preferred = mean.id.load.is_isotropic() && !mean.modulus.empty() && answers(mean.id, tests) &&
                              find_preferred_test(tests, mean.id.load, mean.id.boundary, mean.id.method) == &mean;
    if (!is_preferred) continue;
    const auto shears = shears_beside(dimensions, mean.id, tests);
    const auto first = at_time(shears, mean.modulus.front().time), last = at_time(shears, mean.modulus.back().time);
    if (!first || !last) continue;
    if (!largest) largest = Anisotropy{*first, *last};
    if (first->distance > largest->first.distance) largest->first = *first;
    if (last->distance > largest->last.distance) largest->last = *last;
  }
  return largest;
}

}  // namespace breccia

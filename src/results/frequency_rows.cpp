#include "breccia/results/frequency_rows.hpp"

#include <algorithm>
#include <numbers>

namespace breccia {

FrequencyRows FrequencyRows::of(const Tests& tests) {
  return {tests.by_frequency ? std::optional(tests.points_per_decade) : std::nullopt};
}

std::vector<double> FrequencyRows::of(const Curve& curve) const {
  std::vector<double> frequencies;
  if (!hertz_per_decade) {
    frequencies.resize(curve.size());
    std::transform(curve.rbegin(), curve.rend(), frequencies.begin(),
                   [](const Sample& sample) { return 1.0 / sample.time; });
    return frequencies;
  }
  constexpr double per_cycle = 2.0 * std::numbers::pi;
  const TimeWindow hertz = {1.0 / (per_cycle * curve.back().time), 1.0 / (per_cycle * curve.front().time)};
  for (const double frequency : logarithmic_times(hertz, *hertz_per_decade)) {
    frequencies.push_back(per_cycle * frequency);
  }
  return frequencies;
}

}  // namespace breccia

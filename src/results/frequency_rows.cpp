#include "breccia/results/frequency_rows.hpp"

#include <algorithm>

#include "homogenisation/complex_moduli.hpp"

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
  return frequencies_in_hertz(curve, *hertz_per_decade);
}

}  // namespace breccia

#include "breccia/viscoelasticity/reduction.hpp"

#include <cmath>
#include <cstddef>
#include <iterator>

namespace breccia {

ReducedSeries reduce_to_window(const PronySeries& series, const TimeWindow& window, double tolerance) {
  const double softest = series.at(window.end);
  const auto& terms = series.terms();

  // The search goes inwards from both ends of the spectrum; each side may use half of the tolerance.
  double slow_error = 0.0;
  auto first = terms.begin();
  for (; first != terms.end(); ++first) {
    const double error = -std::abs(first->modulus) * std::expm1(-window.end / first->relaxation_time) / softest;
    if (slow_error + error > 0.5 * tolerance) break;
    slow_error += error;
  }
  double fast_error = 0.0;
  auto last = terms.end();
  for (; last != first; --last) {
    const auto& [relaxation_time, modulus] = *std::prev(last);
    const double dashpot = relaxation_time / window.begin;
    const double error =
        std::abs(modulus) * (std::exp(-window.begin / relaxation_time) + dashpot) / series.at(window.begin);
    if (fast_error + error > 0.5 * tolerance) break;
    fast_error += error;
  }
  const auto slow = static_cast<std::size_t>(first - terms.begin());
  const auto fast = static_cast<std::size_t>(terms.end() - last);
  return {series.truncated(slow, fast), slow_error + fast_error};
}

}  // namespace breccia

#include "homogenisation/box_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "homogenisation/run/isotropic_mean.hpp"

namespace breccia {
namespace {

/// The times that two tests have in common; for a single test all of its times.
TimeWindow common_times(const TestResult* upper, const TestResult* lower) {
  const auto times_of = [](const TestResult& test) {
    return TimeWindow{test.modulus.front().time, test.modulus.back().time};
  };
  if (upper == nullptr || lower == nullptr) return times_of(upper != nullptr ? *upper : *lower);
  const auto one = times_of(*upper), other = times_of(*lower);
  return {std::max(one.begin, other.begin), std::min(one.end, other.end)};
}

std::vector<BoundsAtTime> bounds_at_times(const TestResult* upper, const TestResult* lower) {
  std::vector<BoundsAtTime> bounds;
  const auto window = common_times(upper, lower);
  if (!(window.begin < window.end)) return bounds;
  for (const double time : logarithmic_times(window, 1)) {
    auto& at = bounds.emplace_back(BoundsAtTime{time, {}, {}, {}});
    if (upper != nullptr) at.upper = smoothed_at(upper->modulus, time);
    if (lower != nullptr) at.lower = smoothed_at(lower->modulus, time);
    for (const auto* test : {upper, lower}) {
      const auto band = test == nullptr ? std::nullopt : half_band(*test, time);
      if (band) at.grid_half_band = std::max(at.grid_half_band.value_or(0.0), *band);
    }
  }
  return bounds;
}

}  // namespace

std::optional<double> half_band(const TestResult& test, double time) {
  if (test.half_bands.empty()) return std::nullopt;
  const auto distance = [time](const Sample& sample) { return std::abs(std::log(sample.time / time)); };
  const auto nearest = std::ranges::min_element(test.modulus, {}, distance);
  return test.half_bands.at(static_cast<std::size_t>(nearest - test.modulus.begin()));
}

std::optional<double> BoundsAtTime::distance() const {
  if (!upper || !lower) return std::nullopt;
  return *upper / *lower - 1.0;
}

std::optional<double> BoundsAtTime::crossing() const {
  // Twice the larger half band holds the sum of both; below the least share are rounding errors of equal bounds.
  constexpr double least = 1e-3;
  if (!upper || !lower || !(*lower - *upper > 2.0 * grid_half_band.value_or(0.0))) return std::nullopt;
  const double share = 1.0 - *upper / *lower;
  return share > least ? std::optional(share) : std::nullopt;
}

std::vector<LoadQuality> bounds_of_tests(const StageResult& result) {
  std::vector<LoadQuality> all;
  for (const auto& [name, load] : words<TestLoad>) {
    for (const auto& [method_name, method] : words<Method>) {
      const auto* upper = find_preferred_test(result.tests, load, Boundary::displacement, method);
      const auto* lower = find_preferred_test(result.tests, load, Boundary::traction, method);
      if (upper != nullptr || lower != nullptr) all.push_back({load, method, bounds_at_times(upper, lower)});
    }
  }
  return all;
}

}  // namespace breccia

#include "deck/curves_of_study.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "study/chain.hpp"

namespace breccia {
namespace {

/// The index of the value of a curve that is nearest to a time or frequency.
std::size_t nearest(const SampledCurve& curve, double at) {
  const auto distance = [at](double place) { return std::abs(std::log(place / at)); };
  return static_cast<std::size_t>(std::ranges::min_element(curve.at, {}, distance) - curve.at.begin());
}

}  // namespace

CurvesOfStudy curves_of(const Study& study) {
  const auto& tests = study.tests;
  const auto loads = loads_of(study, study.stages.back());
  CurvesOfStudy curves = {.are_over_frequency = tests.by_frequency,
                          .have_bulk = std::ranges::find(loads, Load::bulk) != loads.end(),
                          .first = tests.first_time,
                          .last = tests.last_time};
  if (tests.by_frequency) {
    curves.first = 1.0 / tests.last_time;
    curves.last = 1.0 / tests.first_time;
  }
  return curves;
}

double stated_error(const std::vector<SampledCurve>& curves, const std::vector<Observation>& observations) {
  double largest = 0.0;
  for (const auto& observation : observations) {
    for (const auto& curve : curves) {
      const bool is_used = curve.curve != ObservedCurve::phase &&
                           (curve.modulus == ObservedModulus::shear || observation.modulus != ObservedModulus::shear);
      if (!is_used) continue;
      const auto& error = curve.errors[nearest(curve, observation.at)];
      if (!error) return 0.0;
      largest = std::max(largest, *error);
    }
  }
  return largest;
}

}  // namespace breccia

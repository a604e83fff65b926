#include "deck/calibrated_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace breccia {
namespace {

/// The index of the value of a curve that is nearest to a time or frequency.
std::size_t nearest(const SampledCurve& curve, double at) {
  const auto distance = [at](double place) { return std::abs(std::log(place / at)); };
  return static_cast<std::size_t>(std::ranges::min_element(curve.at, {}, distance) - curve.at.begin());
}

/// The largest error that the study states of what was measured [-]; 0 where one of these is not known.
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

/// The curves that tests will have.
CurvesOfStudy curves_of(const Tests& tests) {
  CurvesOfStudy curves = {.are_over_frequency = tests.by_frequency,
                          .have_bulk = std::ranges::find(tests.loads, TestLoad(Load::bulk)) != tests.loads.end(),
                          .first = tests.first_time,
                          .last = tests.last_time};
  if (tests.by_frequency) {
    curves.first = 1.0 / tests.last_time;
    curves.last = 1.0 / tests.first_time;
  }
  return curves;
}

}  // namespace

MeasuredComposite read_measured_composite(const DeckAssessment& deck, const AskedObservations& asked,
                                          std::optional<double> model_error) {
  MeasuredComposite measured = {.observations = {},
                                .noise = asked.noise ? Noise::known : Noise::relative,
                                .model_error = model_error,
                                .notes = {}};
  CollectedMistakes mistakes;
  measured.observations = read_observations(asked, measured.notes, mistakes);
  mistakes.collect([&] {
    require_observable(deck.inputs(), measured.observations, curves_of(deck.sweep().tasks.front().study.tests));
  });
  mistakes.refuse();
  return measured;
}

Calibration calibrate_inputs(const DeckAssessment& deck, const std::vector<SampledCurve>& curves,
                             const MeasuredComposite& measured) {
  const double deviation = 0.5 * measured.model_error.value_or(stated_error(curves, measured.observations));
  const auto with = [&](int samples) {
    return calibrate_inputs(deck.inputs(), deck.design(), curves, measured.observations, deviation,
                            {measured.noise, samples});
  };
  constexpr int samples = 100'000, more_samples = 600'000;
  auto found = with(samples);
  const bool are_enough = found.independent_samples && !std::isnan(*found.independent_samples);
  return are_enough ? found : with(more_samples);
}

}  // namespace breccia

#include "deck/calibrated_inputs.hpp"

#include <algorithm>

namespace breccia {
namespace {

/// The largest error that the study states of its curves [-]; 0 where one is not known.
double stated_error(const std::vector<SampledCurve>& curves) {
  double largest = 0.0;
  for (const auto& curve : curves) {
    if (curve.curve == ObservedCurve::phase) continue;
    for (const auto& error : curve.errors) {
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
  constexpr int samples = 100'000;
  const double deviation = 0.5 * measured.model_error.value_or(stated_error(curves));
  return calibrate_inputs(deck.inputs(), deck.design(), curves, measured.observations, deviation,
                          {measured.noise, samples});
}

}  // namespace breccia

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

}  // namespace

CalibratedInputs calibrate_inputs(const DeckAssessment& deck, const std::vector<SampledCurve>& curves,
                                  const AskedObservations& measured, std::optional<double> model_error) {
  constexpr int samples = 100'000;
  CalibratedInputs found;
  CollectedMistakes mistakes;
  found.observations = read_observations(measured, found.notes, mistakes);
  mistakes.refuse();
  const double deviation = 0.5 * model_error.value_or(stated_error(curves));
  const auto noise = measured.noise ? Noise::known : Noise::relative;
  found.result =
      calibrate_inputs(deck.inputs(), deck.design(), curves, found.observations, deviation, {noise, samples});
  return found;
}

}  // namespace breccia

#include "deck/calibrated_inputs.hpp"

#include <cmath>

#include "deck/curves_of_study.hpp"

namespace breccia {

MeasuredComposite read_measured_composite(const DeckAssessment& deck, const AskedObservations& asked,
                                          std::optional<double> model_error) {
  MeasuredComposite measured = {.observations = {},
                                .noise = asked.noise ? Noise::known : Noise::relative,
                                .model_error = model_error,
                                .notes = {}};
  CollectedMistakes mistakes;
  measured.observations = read_observations(asked, measured.notes, mistakes);
  mistakes.collect(
      [&] { require_observable(deck.inputs(), measured.observations, curves_of(deck.sweep().tasks.front().study)); });
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

#include "cli/fitter.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "cli/command.hpp"
#include "cli/fit_law.hpp"
#include "io/units.hpp"

namespace breccia::cli {
namespace {

/// The reference temperature: that of the sweep which the user has selected.
double reference_temperature(const FitChoices& choices, const std::vector<FrequencySweep>& sweeps) {
  std::vector<std::string> temperatures;
  for (const auto& sweep : sweeps) {
    constexpr double zero_celsius = 273.15;
    temperatures.push_back(fmt::format("{:.4g} degC", sweep.temperature - zero_celsius));
  }
  const auto known = fmt::format("the sweeps are at {}", fmt::join(temperatures, ", "));
  if (choices.reference_temperature.empty()) {
    throw InputError(
        fmt::format("{}: several temperatures: expected --reference-temperature; {}", choices.file.string(), known));
  }
  const double wanted =
      option_quantity("--reference-temperature", choices.reference_temperature, Dimension::temperature);
  constexpr double close = 0.5;
  for (const auto& sweep : sweeps) {
    if (std::abs(sweep.temperature - wanted) <= close) return sweep.temperature;
  }
  throw InputError(fmt::format("--reference-temperature: no sweep at {}; {}", choices.reference_temperature, known));
}

/// The result of the fit of a spectrum to dynamic moduli.
FitResult dynamic(RelaxationFit fit, const std::vector<double>& frequencies) {
  return {CurveKind::dynamic,
          fit.series,
          creep_compliance(fit.series),
          {1.0 / frequencies.back(), 1.0 / frequencies.front()},
          std::move(fit.quality)};
}

/// The result of the fit of a law to data in a range of time.
FitResult of_law(CurveKind kind, LawFit fit, FitQuality of_spectrum, const TimeWindow& reach) {
  FitResult result = {kind, fit.series, creep_compliance(fit.series), reach, fit.quality};
  result.law = std::move(fit);
  result.spectrum_quality = std::move(of_spectrum);
  return result;
}

}  // namespace

Fitter::Fitter(FitChoices choices) : choices_(std::move(choices)) {
  options_.times_per_decade = choices_.times_per_decade;
  law_ = value_named<LawForm>(choices_.law);
  if (!law_ && !choices_.law.empty()) throw InputError(fmt::format("--law: no law \"{}\"", choices_.law));
  if (law_) given_ = kept_parameters(*law_, choices_.kept);
  if (law_ && choices_.times_per_decade != FitOptions{}.times_per_decade) {
    throw InputError("--times-per-decade: not with --law, which has no relaxation times of its own");
  }
  if (choices_.ramp.empty()) return;
  if (law_) throw InputError("--ramp: not with --law, which takes the data as those of a step");
  options_.ramp = option_quantity("--ramp", choices_.ramp, Dimension::time, Range::not_negative());
}

FitResult Fitter::operator()(const RelaxationData& data) const {
  refuse_reference();
  if (law_) {
    return of_law(CurveKind::relaxation, fit_law_to_moduli(*law_, data.times, data.moduli, given_),
                  fit_relaxation(data.times, data.moduli, options_).quality, {data.times.front(), data.times.back()});
  }
  auto fit = fit_relaxation(data.times, data.moduli, options_);
  return {CurveKind::relaxation,
          fit.series,
          creep_compliance(fit.series),
          {data.times.front(), data.times.back()},
          std::move(fit.quality)};
}

FitResult Fitter::operator()(const CreepData& data) const {
  refuse_reference();
  if (law_) {
    return of_law(CurveKind::creep, fit_law_to_compliances(*law_, data.times, data.compliances, given_),
                  fit_creep(data.times, data.compliances, options_).quality, {data.times.front(), data.times.back()});
  }
  auto fit = fit_creep(data.times, data.compliances, options_);
  return {CurveKind::creep,
          relaxation_modulus(fit.compliance),
          fit.compliance,
          {data.times.front(), data.times.back()},
          std::move(fit.quality)};
}

FitResult Fitter::operator()(const DynamicData& data) const {
  refuse_ramp();
  if (data.sweeps.size() == 1) {
    refuse_reference();
    const auto& sweep = data.sweeps.front();
    return of_dynamic(fit_dynamic(sweep.frequencies, sweep.storage, sweep.loss, options_), sweep.frequencies,
                      sweep.storage, sweep.loss);
  }
  auto curve = master_curve(data.sweeps, reference_temperature(choices_, data.sweeps), options_);
  auto result = of_dynamic(curve.fit, curve.frequencies, curve.storage, curve.loss);
  constexpr std::size_t fewest = 3;
  if (data.sweeps.size() >= fewest) {
    result.shift_law = fit_williams_landel_ferry(curve.shift_factors, curve.reference_temperature);
  }
  result.master_curve = std::move(curve);
  return result;
}

FitResult Fitter::operator()(const PronySeries& series) const {
  refuse_ramp();
  if (law_) throw InputError("--law: expected measured data, not a Prony series");
  refuse_reference();
  constexpr double beyond = 10.0;
  const auto& terms = series.terms();
  return {CurveKind::relaxation,
          series,
          creep_compliance(series),
          {terms.back().relaxation_time / beyond, terms.front().relaxation_time * beyond}};
}

FitResult Fitter::of_dynamic(RelaxationFit spectrum, const std::vector<double>& frequencies,
                             const std::vector<double>& storage, const std::vector<double>& loss) const {
  if (!law_) return dynamic(std::move(spectrum), frequencies);
  return of_law(CurveKind::dynamic, fit_law_to_dynamic_moduli(*law_, frequencies, storage, loss, given_),
                std::move(spectrum.quality), {1.0 / frequencies.back(), 1.0 / frequencies.front()});
}
void Fitter::refuse_ramp() const {
  if (!choices_.ramp.empty()) throw InputError("--ramp: expected data against time");
}
void Fitter::refuse_reference() const {
  if (choices_.reference_temperature.empty()) return;
  throw InputError("--reference-temperature: expected dynamic moduli at several temperatures");
}

}  // namespace breccia::cli

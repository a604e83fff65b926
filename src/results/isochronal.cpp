#include "results/isochronal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "viscoelasticity/engineering_moduli.hpp"
#include "viscoelasticity/reference_temperature.hpp"

namespace breccia {
namespace {

constexpr double zero_celsius = 273.15;

/// The law of the composite, with the temperature of the study as its reference.
ShiftLaw law_of(const Composite& composite) {
  if (composite.shift) {
    return std::visit([&](const auto& law) -> ShiftLaw { return with_reference(law, composite.shift->temperature); },
                      composite.shift->law);
  }
  throw InputError(
      fmt::format("stage {}: its moduli at other temperatures are not known: the binder has no shift with the "
                  "temperature, or another material relaxes, too",
                  composite.stage));
}

double temperature_at(const ShiftLaw& law, double log10_factor) {
  return std::visit([log10_factor](const auto& one) { return one.temperature_at(log10_factor); }, law);
}

double celsius(double kelvin) {
  return kelvin - zero_celsius;
}

/// The covered temperatures within 100 K of the temperature of the study, from a multiple of the step in degrees
/// Celsius; all covered temperatures if they are further away.
TemperatureRange default_temperatures(const Composite& composite, const TemperatureRange& covered, double step) {
  constexpr double near = 100.0;  // distance [K]; shift laws are measured over smaller ranges
  TemperatureRange range = {std::max(covered.begin, composite.shift->temperature - near),
                            std::min(covered.end, composite.shift->temperature + near)};
  if (range.begin >= range.end) range = covered;
  return {zero_celsius + step * std::ceil(celsius(range.begin) / step), range.end};
}

double hertz(double omega) {
  return omega / (2.0 * std::numbers::pi);
}

}  // namespace

TemperatureRange temperatures_covered(const Composite& composite, double omega) {
  const auto law = law_of(composite);
  // Temperature beyond the use of any polymer [K]; the law may never reach the slowest frequency.
  constexpr double hottest = 2000.0;
  const TemperatureRange covered = {temperature_at(law, -std::log10(omega * composite.times.begin)),
                                    std::min(temperature_at(law, -std::log10(omega * composite.times.end)), hottest)};
  if (covered.begin < covered.end) return covered;
  throw InputError(
      fmt::format("{:.4g} Hz: no temperature at which the times of the study, {:.3g} to {:.3g} s, cover it",
                  hertz(omega), composite.times.begin, composite.times.end));
}

std::vector<IsochronalSample> isochronal_curve(const Composite& composite, double omega,
                                               const std::optional<TemperatureRange>& temperatures, double step) {
  std::vector<std::string> mistakes;
  if (!(omega > 0.0 && std::isfinite(omega)))
    mistakes.push_back(fmt::format("frequency: expected one above zero, got {} rad/s", omega));
  if (!(step > 0.0 && std::isfinite(step)))
    mistakes.push_back(fmt::format("step: expected one above zero, got {} K", step));
  if (temperatures && !(temperatures->begin < temperatures->end))
    mistakes.emplace_back("temperatures: expected two rising ones");
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
  const auto law = law_of(composite);
  const auto covered = temperatures_covered(composite, omega);
  constexpr double rounding = 1e-6;
  if (temperatures && (temperatures->begin < covered.begin - rounding || temperatures->end > covered.end + rounding)) {
    throw InputError(fmt::format(
        "temperatures: at {:.4g} Hz the times of the study, {:.3g} to {:.3g} s, and the shift factors of its binder "
        "cover {:.4g} to {:.4g} degC, got {:.6g} to {:.6g} degC ({:.6g} to {:.6g} K)",
        hertz(omega), composite.times.begin, composite.times.end, celsius(covered.begin), celsius(covered.end),
        celsius(temperatures->begin), celsius(temperatures->end), temperatures->begin, temperatures->end));
  }
  const auto range = temperatures.value_or(default_temperatures(composite, covered, step));
  if (range.begin > range.end + rounding) {
    throw InputError(fmt::format(
        "step: at {:.4g} Hz the times of the study, {:.3g} to {:.3g} s, cover {:.4g} to {:.4g} degC only, without a "
        "multiple of {:g} K; expected a smaller step",
        hertz(omega), composite.times.begin, composite.times.end, celsius(covered.begin), celsius(covered.end), step));
  }
  constexpr double most_samples = 1e5;
  if ((range.end - range.begin) / step > most_samples) throw InputError("step: too small for these temperatures");
  const auto bulk = composite.bulk();
  std::vector<IsochronalSample> samples;
  for (int i = 0; range.begin + i * step <= range.end + rounding; ++i) {
    const double temperature = range.begin + i * step;
    const double factor = shift_factor(law, temperature);
    IsochronalSample sample{temperature, std::log10(factor), composite.shear.complex_modulus(factor * omega)};
    if (bulk) {
      const EngineeringModuli moduli(composite.shear, *bulk);
      sample.young = moduli.complex_youngs_modulus(factor * omega);
      sample.poisson = moduli.complex_poisson_ratio(factor * omega);
    }
    samples.push_back(sample);
  }
  return samples;
}

std::string table_of(const std::vector<IsochronalSample>& samples, const Composite& composite, double omega) {
  auto text = fmt::format(
      "# {}, stage {}: {}, load {}, at {:.6g} Hz; by breccia {}\n"
      "# From the moduli at {} K by the shift of the binder, without a vertical shift\n",
      composite.title, composite.stage, boundary_in_words(composite.boundary), name_of(composite.shear_load),
      omega / (2.0 * std::numbers::pi), BRECCIA_VERSION, composite.shift ? composite.shift->temperature : 0.0);
  text +=
      "temperature_K,temperature_degC,log10_shift_factor,shear_storage_modulus_Pa,shear_loss_modulus_Pa,shear_loss_"
      "tangent";
  const bool has_young = !samples.empty() && samples.front().young.has_value();
  if (has_young) {
    text +=
        ",youngs_storage_modulus_Pa,youngs_loss_modulus_Pa,youngs_loss_tangent,poisson_ratio_real,"
        "poisson_ratio_imaginary";
  }
  text += "\n";
  for (const auto& [temperature, log10_factor, shear, young, poisson] : samples) {
    text += fmt::format("{:.10g},{:.10g},{:.10g},{},{},{}", temperature, celsius(temperature), log10_factor,
                        shear.real(), shear.imag(), shear.imag() / shear.real());
    if (young)
      text += fmt::format(",{},{},{},{},{}", young->real(), young->imag(), young->imag() / young->real(),
                          poisson->real(), poisson->imag());
    text += "\n";
  }
  return text;
}

}  // namespace breccia

#include "deck/laws.hpp"

#include <limits>
#include <optional>
#include <vector>

#include "breccia/viscoelasticity/law_form.hpp"
#include "breccia/viscoelasticity/law_series.hpp"

#include "deck/known_numbers.hpp"

namespace breccia {
namespace {

/// Exponents between 0 and 1, without these.
constexpr Range exponents = Range::between(0.0, 1.0);

/// The series of a law whose numbers have been read; empty if one of them is NaN, after a mistake, or if they do not
/// fit together, which is reported.
template <class Law>
PronySeries series_or_mistake(const Section& section, const Law& law, const std::vector<double>& numbers) {
  PronySeries series;
  if (are_known(numbers)) section.report_errors_of("law", [&] { series = series_of(law); });
  return series;
}

PronySeries read_2s2p1d(const Section& section) {
  constexpr double without_dashpot = std::numeric_limits<double>::infinity();
  const TwoSpringsTwoParabolasDashpot law = {
      .static_modulus = section.quantity("static", Dimension::pressure, Range::not_negative()),
      .glassy_modulus = section.quantity("glassy", Dimension::pressure, Range::positive()),
      .delta = section.number("delta", Range::positive()),
      .time = section.quantity("time", Dimension::time, Range::positive()),
      .k = section.number("k", exponents),
      .h = section.number("h", exponents),
      .beta = section.optional_number("beta", Range::positive()).value_or(without_dashpot)};
  return series_or_mistake<RelaxationLaw>(
      section, law, {law.static_modulus, law.glassy_modulus, law.delta, law.time, law.k, law.h, law.beta});
}

PronySeries read_fractional_zener(const Section& section) {
  const FractionalZener law = {
      .equilibrium = section.optional_quantity("equilibrium", Dimension::pressure, Range::not_negative()).value_or(0.0),
      .unrelaxed = section.quantity("unrelaxed", Dimension::pressure, Range::positive()),
      .time = section.quantity("time", Dimension::time, Range::positive()),
      .exponent = section.number("exponent", exponents)};
  return series_or_mistake<RelaxationLaw>(section, law, {law.equilibrium, law.unrelaxed, law.time, law.exponent});
}

template <class Law>
PronySeries read_creep(const Section& section, double exponent) {
  const Law law = {.instantaneous = section.quantity("instantaneous", Dimension::compliance, Range::positive()),
                   .creep = section.quantity("creep", Dimension::compliance, Range::positive()),
                   .time = section.quantity("time", Dimension::time, Range::positive()),
                   .exponent = exponent};
  return series_or_mistake<CreepLaw>(section, law, {law.instantaneous, law.creep, law.time, law.exponent});
}

PronySeries read_power_law_creep(const Section& section) {
  return read_creep<PowerLawCreep>(section, section.number("exponent", exponents));
}

PronySeries read_logarithmic_creep(const Section& section) {
  constexpr double natural = 1.0;
  const auto exponent = section.optional_number("exponent", Range::above_and_up_to(0.0, natural));
  return read_creep<LogarithmicCreep>(section, exponent.value_or(natural));
}

}  // namespace

PronySeries read_law(const Section& modulus) {
  const auto form = modulus.choice<LawForm>("law");
  if (!form) {
    modulus.accept_all_keys();  // the law decides which of the keys are allowed
    return {};
  }
  switch (*form) {
    case LawForm::two_springs_two_parabolas_dashpot:
      return read_2s2p1d(modulus);
    case LawForm::fractional_zener:
      return read_fractional_zener(modulus);
    case LawForm::power_law_creep:
      return read_power_law_creep(modulus);
    case LawForm::logarithmic_creep:
      break;
  }
  return read_logarithmic_creep(modulus);
}

}  // namespace breccia

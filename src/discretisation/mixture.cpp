#include "breccia/discretisation/mixture.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

namespace breccia {
namespace {

/// The harmonic mean of a modulus [Pa] of the phases.
double series_modulus(const Mixture& mixture, std::span<const Moduli> by_phase, double Moduli::*modulus) {
  double compliance = 0.0;
  for (const auto& [phase, fraction] : mixture) {
    const double of_phase = by_phase[phase].*modulus;
    if (of_phase == 0.0) return 0.0;
    compliance += fraction / of_phase;
  }
  return 1.0 / compliance;
}

/// The modulus whose creep compliance is the mean of those of the phases.
PronySeries series_modulus(const Mixture& mixture, std::span<const Material> by_phase, PronySeries Material::*modulus) {
  double instantaneous = 0.0, fluidity = 0.0;
  std::map<double, double> terms;
  for (const auto& [phase, fraction] : mixture) {
    const auto& series = by_phase[phase].*modulus;
    if (std::ranges::any_of(series.terms(), [](const MaxwellTerm& term) { return term.modulus < 0.0; })) {
      throw InputError(
          fmt::format("mixed cells: the bulk modulus of {} rises in places, as that of a composite may; "
                      "expected a material whose moduli only fall",
                      by_phase[phase].name));
    }
    const auto compliance = creep_compliance(series);
    instantaneous += fraction * compliance.instantaneous();
    fluidity += fraction * compliance.fluidity();
    for (const auto& [time, strength] : compliance.terms()) terms[time] += fraction * strength;
  }
  std::vector<RetardationTerm> spectrum;
  spectrum.reserve(terms.size());
  for (const auto& [time, strength] : terms) spectrum.push_back({time, strength});
  return relaxation_modulus(CreepCompliance(instantaneous, std::move(spectrum), fluidity));
}

}  // namespace

Moduli series_moduli(const Mixture& mixture, std::span<const Moduli> by_phase) {
  return {.bulk = series_modulus(mixture, by_phase, &Moduli::bulk),
          .shear = series_modulus(mixture, by_phase, &Moduli::shear)};
}

Material series_material(const Mixture& mixture, std::span<const Material> by_phase) {
  std::string name;
  double density = 0.0;
  for (const auto& [phase, fraction] : mixture) {
    const auto& material = by_phase[phase];
    name += fmt::format("{}{:.3g} {}", name.empty() ? "" : " + ", fraction, material.name);
    density += fraction * material.density;
  }
  return {std::move(name), density, series_modulus(mixture, by_phase, &Material::bulk),
          series_modulus(mixture, by_phase, &Material::shear)};
}

}  // namespace breccia

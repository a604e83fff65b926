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
template <class Modulus>
double series_modulus(const Mixture& mixture, std::span<const Moduli> by_phase, const Modulus& modulus) {
  double compliance = 0.0;
  for (const auto& [phase, fraction] : mixture) {
    const double of_phase = modulus(by_phase[phase]);
    if (of_phase == 0.0) return 0.0;
    compliance += fraction / of_phase;
  }
  return 1.0 / compliance;
}

PronySeries shear_modulus(const Material& material) {
  return material.shear;
}

/// The modulus whose creep compliance is the mean of those of the phases.
template <int dim>
PronySeries series_modulus(const Mixture& mixture, std::span<const Material> by_phase,
                           PronySeries (*modulus)(const Material&)) {
  double instantaneous = 0.0, fluidity = 0.0;
  std::map<double, double> terms;
  for (const auto& [phase, fraction] : mixture) {
    const auto series = modulus(by_phase[phase]);
    if (std::ranges::any_of(series.terms(), [](const MaxwellTerm& term) { return term.modulus < 0.0; })) {
      throw InputError(fmt::format("mixed cells: a modulus of {} rises with time; expected {} and G that only fall",
                                   by_phase[phase].name, dim == 2 ? "K + G/3" : "K"));
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

template <int dim>
Moduli series_moduli(const Mixture& mixture, std::span<const Moduli> by_phase) {
  const double shear = series_modulus(mixture, by_phase, [](const Moduli& moduli) { return moduli.shear; });
  const double dilatational = series_modulus(mixture, by_phase, dilatational_modulus<dim>);
  return {.bulk = dim == 2 ? dilatational - shear / 3.0 : dilatational, .shear = shear};
}

template Moduli series_moduli<2>(const Mixture&, std::span<const Moduli>);
template Moduli series_moduli<3>(const Mixture&, std::span<const Moduli>);

template <int dim>
Material series_material(const Mixture& mixture, std::span<const Material> by_phase) {
  std::string name;
  double density = 0.0;
  for (const auto& [phase, fraction] : mixture) {
    const auto& material = by_phase[phase];
    name += fmt::format("{}{:.3g} {}", name.empty() ? "" : " + ", fraction, material.name);
    density += fraction * material.density;
  }
  const auto shear = series_modulus<dim>(mixture, by_phase, shear_modulus);
  const auto dilatational = series_modulus<dim>(mixture, by_phase, dilatational_series<dim>);
  const auto bulk = dim == 2 ? PronySeries::difference(dilatational, shear.scaled(1.0 / 3.0)) : dilatational;
  return {std::move(name), density, bulk, shear};
}

template Material series_material<2>(const Mixture&, std::span<const Material>);
template Material series_material<3>(const Mixture&, std::span<const Material>);

}  // namespace breccia

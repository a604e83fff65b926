#include "discretisation/mixture_rule.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "discretisation/contrast.hpp"

namespace breccia {
namespace {

bool are_equal(double one, double other, double tolerance) {
  return std::abs(std::log(one / other)) < tolerance;
}

/// The modulus of phases in series: its creep compliance is the mean of theirs.
PronySeries in_series(std::span<const PronySeries> moduli, std::span<const double> shares) {
  double instantaneous = 0.0, fluidity = 0.0;
  std::map<double, double> terms;
  for (std::size_t part = 0; part < moduli.size(); ++part) {
    const double share = shares[part];
    const auto compliance = creep_compliance(moduli[part]);
    instantaneous += share * compliance.instantaneous();
    fluidity += share * compliance.fluidity();
    for (const auto& [time, strength] : compliance.terms()) terms[time] += share * strength;
  }
  std::vector<RetardationTerm> spectrum;
  for (const auto& [time, strength] : terms) {
    constexpr double rounding = 1e-10;
    if (!spectrum.empty() && are_equal(time, spectrum.back().retardation_time, rounding)) {
      spectrum.back().compliance += strength;
    } else {
      spectrum.push_back({time, strength});
    }
  }
  return relaxation_modulus(CreepCompliance(instantaneous, std::move(spectrum), fluidity));
}

/// A modulus whose relaxation times are those of another one where they differ by rounding alone.
PronySeries with_times_of(const PronySeries& reference, const PronySeries& modulus) {
  auto result = PronySeries(modulus.equilibrium());
  for (auto [time, strength] : modulus.terms()) {
    constexpr double rounding = 1e-8;
    for (const auto& term : reference.terms()) {
      if (are_equal(time, term.relaxation_time, rounding)) time = term.relaxation_time;
    }
    result = PronySeries::sum(result, PronySeries(0.0, {{time, strength}}));
  }
  return result;
}

/// The difference of a modulus and a part of it, none of whose terms is negative but by rounding. The relaxation times
/// of the part are those of the whole, but for rounding.
PronySeries rest(const PronySeries& whole, const PronySeries& part) {
  constexpr double rounding = 1e-6, least = 1e-9;
  auto terms = whole.terms();
  for (const auto& [time, modulus] : part.terms()) {
    const auto distance = [time = time](const MaxwellTerm& term) {
      return std::abs(std::log(term.relaxation_time / time));
    };
    const auto same = std::ranges::min_element(terms, {}, distance);
    if (same == terms.end() || distance(*same) > rounding || same->modulus < (1.0 - least) * modulus) {
      throw NumericalError(fmt::format(
          "mixed cells: the relaxation time {:.6g} s of the matrix is lost in a mixture by rounding", time));
    }
    *same = {time, std::max(same->modulus - modulus, 0.0)};
    if (same->modulus <= least * modulus) terms.erase(same);
  }
  return {std::max(whole.equilibrium() - part.equilibrium(), 0.0), std::move(terms)};
}

PronySeries shear_modulus(const Material& material) {
  return material.shear;
}

void require_falling(const PronySeries& modulus, const std::string& material, int dim) {
  if (std::ranges::none_of(modulus.terms(), [](const MaxwellTerm& term) { return term.modulus < 0.0; })) return;
  throw InputError(fmt::format("mixed cells: a modulus of {} rises with time; expected {} and G that only fall",
                               material, dim == 2 ? "K + G/3" : "K"));
}

}  // namespace

MixtureRule::MixtureRule(Mixture mixture) : mixture_(std::move(mixture)) {
  for (const auto& part : mixture_) shares_.emplace_back(part.fraction, part.fraction);
}

MixtureRule::MixtureRule(Mixture mixture, std::span<const Material> by_phase) : MixtureRule(std::move(mixture)) {
  const auto is_matrix = [](const MixedPart& part) { return part.phase == matrix; };
  const auto is_empty = [&](const MixedPart& part) { return is_void(by_phase[part.phase]); };
  if (std::ranges::any_of(mixture_, is_empty)) {
    // The matrix, where the cell has some, since it has the least number.
    for (const auto& part : mixture_) {
      if (!is_empty(part)) holding_ = std::min(holding_.value_or(part.phase), part.phase);
    }
  } else if (std::ranges::any_of(mixture_, is_matrix) && are_softer_than_matrix(by_phase)) {
    holding_ = matrix;
  }
}

template <int dim>
std::vector<VolumeAndShear> MixtureRule::constrained(std::span<const Moduli> by_phase) const {
  const auto held = constraint(by_phase);
  std::vector<VolumeAndShear> moduli;
  moduli.reserve(mixture_.size());
  for (const auto& part : mixture_) {
    const auto& of_phase = by_phase[part.phase];
    moduli.emplace_back(dilatational_modulus<dim>(of_phase) + held[0], of_phase.shear + held[1]);
  }
  return moduli;
}

VolumeAndShear MixtureRule::in_series(std::span<const VolumeAndShear> constrained) const {
  VolumeAndShear compliance = VolumeAndShear::Zero();
  for (std::size_t part = 0; part < constrained.size(); ++part) {
    compliance += shares_[part] / constrained[part];  // infinite where there is no stiffness
  }
  return 1.0 / compliance;
}

template <int dim>
Moduli MixtureRule::moduli(std::span<const Moduli> by_phase) const {
  const VolumeAndShear mixed = in_series(constrained<dim>(by_phase)) - constraint(by_phase);
  return {.bulk = dim == 2 ? mixed[0] - mixed[1] / 3.0 : mixed[0], .shear = mixed[1]};
}

template <int dim>
PronySeries MixtureRule::modulus(std::span<const Material> by_phase, PronySeries (*of_phase)(const Material&),
                                 Eigen::Index mode) const {
  const auto held = holding_ ? by_phase[*holding_].shear.scaled(of_unit_shear()[mode]) : PronySeries();
  std::vector<double> shares;
  for (const auto& share : shares_) shares.push_back(share[mode]);
  std::vector<PronySeries> moduli;
  for (const auto& part : mixture_) {
    const auto& material = by_phase[part.phase];
    moduli.push_back(of_phase(material));
    require_falling(moduli.back(), material.name, dim);
    if (holding_) moduli.back() = PronySeries::sum(with_times_of(held, moduli.back()), held);
  }
  const auto mixed = breccia::in_series(moduli, shares);
  return holding_ ? rest(mixed, held) : mixed;
}

template <int dim>
Material MixtureRule::material(std::span<const Material> by_phase) const {
  std::string name;
  double density = 0.0;
  for (const auto& [phase, fraction] : mixture_) {
    const auto& material = by_phase[phase];
    name += fmt::format("{}{:.3g} {}", name.empty() ? "" : " + ", fraction, material.name);
    density += fraction * material.density;
  }
  const auto shear = modulus<dim>(by_phase, shear_modulus, 1);
  const auto dilatational = modulus<dim>(by_phase, dilatational_series<dim>, 0);
  const auto bulk = dim == 2 ? PronySeries::difference(dilatational, shear.scaled(1.0 / 3.0)) : dilatational;
  return {std::move(name), density, bulk, shear};
}

template std::vector<VolumeAndShear> MixtureRule::constrained<2>(std::span<const Moduli>) const;
template std::vector<VolumeAndShear> MixtureRule::constrained<3>(std::span<const Moduli>) const;
template Moduli MixtureRule::moduli<2>(std::span<const Moduli>) const;
template Moduli MixtureRule::moduli<3>(std::span<const Moduli>) const;
template Material MixtureRule::material<2>(std::span<const Material>) const;
template Material MixtureRule::material<3>(std::span<const Material>) const;

}  // namespace breccia

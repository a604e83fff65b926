#include "breccia/viscoelasticity/interconversion.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "breccia/error.hpp"

namespace breccia {
namespace {

/// A rate, stored as the offset from another rate, so that a small distance between the two keeps its full relative
/// precision.
struct Rate {
  double base = 0.0;
  double offset = 0.0;

  [[nodiscard]] double value() const noexcept { return base + offset; }
  /// The difference between the other rate and this one.
  [[nodiscard]] double distance_to(double other) const noexcept { return (other - base) - offset; }
};

/// The zero of a function that rises from negative values at `low` to positive ones at `high`, found by bisection in
/// the logarithm of the distance to the closer end. Both ends may be poles.
template <class Function>
Rate root_between(double low, double high, const Function& function) {
  const double half = 0.5 * (high - low);
  const bool is_low = function(Rate{low, half}) >= 0.0;
  const double base = is_low ? low : high;
  const double sign = is_low ? 1.0 : -1.0;
  double near = 1e-300, far = half;
  while (far > near * (1.0 + 4e-16)) {
    const double middle = std::sqrt(near) * std::sqrt(far);
    if (middle <= near || middle >= far) break;
    const bool is_beyond = (function(Rate{base, sign * middle}) >= 0.0) == is_low;
    (is_beyond ? far : near) = middle;
  }
  return {base, sign * far};
}

/// Rates and strengths of the terms by rising rate; terms of equal rate are merged, terms of zero strength left out.
struct Term {
  double rate = 0.0;
  double strength = 0.0;
};

void add(std::vector<Term>& terms, double rate, double strength) {
  if (strength == 0.0) return;
  if (!terms.empty() && terms.back().rate == rate) {
    terms.back().strength += strength;
  } else {
    terms.push_back({rate, strength});
  }
}

}  // namespace

CreepCompliance creep_compliance(const PronySeries& modulus) {
  std::vector<Term> terms;
  for (const auto& [time, strength] : modulus.terms()) add(terms, 1.0 / time, strength);
  const double unrelaxed = modulus.unrelaxed(), equilibrium = modulus.equilibrium();
  if (!(unrelaxed > 0.0)) throw InputError("creep compliance: the modulus is zero at all times");

  // The rates are the zeros of s G~(s) at s = -r: -G_inf + sum_i G_i r / (p_i - r) = 0.
  const auto negative_modulus = [&](const Rate& rate) {
    double sum = -equilibrium;
    for (const auto& [pole, strength] : terms) sum += strength * rate.value() / rate.distance_to(pole);
    return sum;
  };
  std::vector<RetardationTerm> retarded;
  double viscosity = 0.0;
  for (const auto& [pole, strength] : terms) viscosity += strength / pole;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    // Without an equilibrium modulus the zero below the slowest term is at r = 0: the material flows.
    if (k == 0 && equilibrium == 0.0) continue;
    const auto rate = root_between(k == 0 ? 0.0 : terms[k - 1].rate, terms[k].rate, negative_modulus);
    double slope = 0.0;
    for (const auto& [pole, strength] : terms) {
      const double distance = rate.distance_to(pole);
      slope += strength * pole / distance / distance;
    }
    retarded.push_back({1.0 / rate.value(), 1.0 / (rate.value() * slope)});
  }
  const double fluidity = equilibrium == 0.0 ? 1.0 / viscosity : 0.0;
  return {1.0 / unrelaxed, std::move(retarded), fluidity};
}

PronySeries relaxation_modulus(const CreepCompliance& compliance) {
  const double instantaneous = compliance.instantaneous(), fluidity = compliance.fluidity();
  std::vector<Term> terms;
  double total = instantaneous;
  for (const auto& [time, strength] : compliance.terms()) {
    add(terms, 1.0 / time, strength);
    total += strength;
  }

  // The rates are the zeros of s J~(s) at s = -r: J_0 + sum_i J_i p_i / (p_i - r) - phi / r = 0.
  const auto negative_compliance = [&](const Rate& rate) {
    double sum = instantaneous - fluidity / rate.value();
    for (const auto& [pole, strength] : terms) sum += strength * pole / rate.distance_to(pole);
    return sum;
  };
  std::vector<double> ends;
  if (fluidity > 0.0) ends.push_back(0.0);
  double furthest = fluidity;
  for (const auto& [pole, strength] : terms) {
    ends.push_back(pole);
    furthest += strength * pole;
  }
  // Beyond this distance from the fastest term the function is positive.
  if (!ends.empty()) ends.push_back(ends.back() + 2.0 * furthest / instantaneous);

  std::vector<MaxwellTerm> relaxing;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const auto rate = root_between(ends[k], ends[k + 1], negative_compliance);
    const double r = rate.value();
    double slope = fluidity / r / r;
    for (const auto& [pole, strength] : terms) {
      const double distance = rate.distance_to(pole);
      slope += strength * pole / distance / distance;
    }
    relaxing.push_back({1.0 / r, 1.0 / (r * slope)});
  }
  return {fluidity > 0.0 ? 0.0 : 1.0 / total, std::move(relaxing)};
}

}  // namespace breccia

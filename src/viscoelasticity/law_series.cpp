#include "breccia/viscoelasticity/law_series.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

namespace breccia {
namespace {

constexpr double tolerance = 1e-3;
constexpr int decades_to_a_side = 12;  ///< over which the tolerance holds
constexpr int margin = 3;              ///< decades beyond these that have terms of their own

/// A point of the midpoint rule: a time and the strength of the spectrum around it, H(tau) d ln tau.
struct Node {
  double time = 0.0;
  double strength = 0.0;
};

/// The nodes of a spectrum, and what lies beyond them.
struct Nodes {
  std::vector<Node> inside;  ///< by rising time
  double step = 0.0;         ///< ratio of neighbouring times [-]
  double first = 0.0;        ///< time of the node before those inside
  double last = 0.0;         ///< time of the node after those inside
};

/// Evaluates a spectrum at logarithmic times around a centre.
template <class Spectrum>
Nodes nodes_of(const Spectrum& spectrum, double centre, int per_decade) {
  const int end = (decades_to_a_side + margin) * per_decade;
  const double width = std::numbers::ln10 / per_decade;
  const auto time = [&](int i) { return centre * std::pow(10.0, static_cast<double>(i) / per_decade); };
  Nodes nodes{.inside = {}, .step = std::exp(width), .first = time(-end - 1), .last = time(end + 1)};
  for (int i = -end; i <= end; ++i) nodes.inside.push_back({time(i), spectrum(time(i)) * width});
  return nodes;
}

/// The sum of a quantity over the nodes that continue a spectrum beyond `from`, each `step` times further than the one
/// before it, until what is left does not count. Where the times end before that, the rest is that of a geometric
/// series: the spectra are powers of time far away from their centre.
template <class Quantity>
double sum_beyond(const Quantity& quantity, double from, double step) {
  constexpr double negligible = 1e-12, shortest = 1e-250, longest = 1e250;
  double sum = 0.0, added = 0.0, ratio = 0.0;
  for (double time = from; time > shortest && time < longest; time *= step) {
    const double before = std::exchange(added, quantity(time));
    sum += added;
    if (added <= negligible * sum) return sum;
    ratio = before > 0.0 ? added / before : 0.0;
  }
  return ratio < 1.0 ? sum + added * ratio / (1.0 - ratio) : sum;
}

/// The relaxation modulus of a spectrum. What relaxes after the last node does so there; what relaxes before the first
/// one does so there, so that the modulus at t = 0 is that of the law. Where the sum over the nodes exceeds that
/// modulus, by the error of the rule, all terms are less by the same factor.
PronySeries discretised(const RelaxationLaw& law, int per_decade) {
  const auto spectrum = [&law](double time) { return relaxation_spectrum(law, time); };
  const auto nodes = nodes_of(spectrum, characteristic_time(law), per_decade);
  const double width = std::log(nodes.step), equilibrium = equilibrium_modulus(law);
  double modulus = equilibrium;
  std::vector<MaxwellTerm> terms;
  const auto add = [&](double time, double strength) {
    constexpr double negligible = 1e-12;  // of the modulus that is left at that time
    if (strength <= negligible * modulus) return;
    terms.push_back({time, strength});
    modulus += strength;
  };
  add(nodes.last, sum_beyond([&](double time) { return spectrum(time) * width; }, nodes.last, nodes.step));
  std::for_each(nodes.inside.rbegin(), nodes.inside.rend(), [&](const Node& node) { add(node.time, node.strength); });
  const double total = unrelaxed_modulus(law) - equilibrium, found = modulus - equilibrium;
  add(nodes.first, total - found);
  if (found > total) {
    for (auto& term : terms) term.modulus *= total / found;
  }
  return {equilibrium, std::move(terms)};
}

/// The creep compliance of a spectrum. What lies beyond the last node flows at a constant rate; what lies before the
/// first node has the retardation time of the node before it.
CreepCompliance discretised(const CreepLaw& law, int per_decade) {
  const auto spectrum = [&law](double time) { return retardation_spectrum(law, time); };
  const auto nodes = nodes_of(spectrum, characteristic_time(law), per_decade);
  const double width = std::log(nodes.step), instantaneous = instantaneous_compliance(law);
  std::vector<RetardationTerm> terms;
  const auto add = [&](double time, double strength) {
    constexpr double negligible = 1e-12;  // of the compliance at t = 0
    if (strength > negligible * instantaneous) terms.push_back({time, strength});
  };
  add(nodes.first, sum_beyond([&](double time) { return spectrum(time) * width; }, nodes.first, 1.0 / nodes.step));
  for (const auto& node : nodes.inside) add(node.time, node.strength);
  const double fluidity =
      sum_beyond([&](double time) { return spectrum(time) * width / time; }, nodes.last, nodes.step);
  return {instantaneous, std::move(terms), fluidity};
}

/// The times at which a series is compared with its law, ten a decade.
std::vector<double> compared_times(double centre) {
  constexpr int per_decade = 10, end = decades_to_a_side * per_decade;
  std::vector<double> times;
  times.reserve(2 * static_cast<std::size_t>(end) + 1);
  for (int i = -end; i <= end; ++i) times.push_back(centre * std::pow(10.0, static_cast<double>(i) / per_decade));
  return times;
}

double deviation(const RelaxationLaw& law, const PronySeries& series, double time) {
  const auto exact = carson_modulus(law, {0.0, 1.0 / time});
  return std::abs(series.complex_modulus(1.0 / time) - exact) / std::abs(exact);
}

double deviation(const CreepLaw& law, const CreepCompliance& compliance, double time) {
  return std::abs(compliance.at(time) / compliance_at(law, time) - 1.0);
}

PronySeries modulus_of(PronySeries series) {
  return series;
}

PronySeries modulus_of(const CreepCompliance& compliance) {
  return relaxation_modulus(compliance);
}

/// The coarsest series within the tolerance.
template <class Law>
PronySeries coarsest(const Law& law) {
  require_valid(law);
  const auto times = compared_times(characteristic_time(law));
  for (const int per_decade : {2, 3, 4, 6, 8, 12, 16, 24}) {
    auto found = discretised(law, per_decade);
    const auto follows = [&](double time) { return deviation(law, found, time) <= tolerance; };
    if (std::ranges::all_of(times, follows)) return modulus_of(std::move(found));
  }
  throw InputError(
      "no series of 24 terms a decade follows this law within 0.1 %: its exponents are too close to 0 or to 1; "
      "expected others, or a Prony series in place of the law");
}

}  // namespace

PronySeries series_of(const RelaxationLaw& law) {
  return coarsest(law);
}

PronySeries series_of(const CreepLaw& law) {
  return coarsest(law);
}

}  // namespace breccia

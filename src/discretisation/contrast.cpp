#include "discretisation/contrast.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace breccia {
namespace {

/// Whether a modulus is lower than another one at some time, and higher at none. Both fall with time, in steps about
/// their relaxation times.
bool is_lower(const PronySeries& one, const PronySeries& other) {
  std::vector<double> times = {0.0, std::numeric_limits<double>::infinity()};
  for (const auto* series : {&one, &other}) {
    for (const auto& term : series->terms()) {
      for (const double factor : {0.1, 0.3, 1.0, 3.0, 10.0}) times.push_back(factor * term.relaxation_time);
    }
  }
  const auto is_higher_at = [&](double time) { return one.at(time) > other.at(time); };
  const auto is_lower_at = [&](double time) { return one.at(time) < other.at(time); };
  return std::ranges::none_of(times, is_higher_at) && std::ranges::any_of(times, is_lower_at);
}

}  // namespace

bool are_softer_than_matrix(std::span<const Material> by_phase) {
  return std::ranges::all_of(by_phase.subspan(1),
                             [&](const Material& other) { return is_lower(other.shear, by_phase.front().shear); });
}

bool are_stiffer_than_matrix(std::span<const Material> by_phase) {
  return std::ranges::all_of(by_phase.subspan(1),
                             [&](const Material& other) { return is_lower(by_phase.front().shear, other.shear); });
}

Moduli least_of_solids(std::span<const Moduli> by_phase) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Moduli least = {.bulk = infinite, .shear = infinite};
  for (const auto& phase : by_phase) {
    if (is_void(phase)) continue;
    least = {.bulk = std::min(least.bulk, phase.bulk), .shear = std::min(least.shear, phase.shear)};
  }
  return least;
}

}  // namespace breccia

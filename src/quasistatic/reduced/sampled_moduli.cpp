#include "quasistatic/reduced/sampled_moduli.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "quasistatic/reduced/carson_path.hpp"

namespace breccia {
namespace {

/// Widens a range to include these moduli.
void widen(ModuliRange& range, const Moduli& moduli) {
  range.least = {std::min(range.least.bulk, moduli.bulk), std::min(range.least.shear, moduli.shear)};
  range.most = {std::max(range.most.bulk, moduli.bulk), std::max(range.most.shear, moduli.shear)};
}

ModuliRange empty_range() {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return {{infinite, infinite}, {-infinite, -infinite}};
}

/// Moduli of the phase at an index in the list of those that vary for which a response can be used.
ModuliRange usable_range(const ReducedResponse& response, std::size_t phase) {
  auto range = empty_range();
  for (const auto& snapshot : response.snapshots) widen(range, snapshot.moduli[phase]);
  // The ends of the range are snapshots. The error is of second order in the distance from a snapshot, so it is below
  // the tolerance for moduli that differ by the spacing of the training set. A bulk modulus outside the training set
  // does little harm: the matrix is nearly incompressible, or its volume change has little influence.
  constexpr double off_shear = 0.05, off_bulk = 0.1;
  // The training set has eight points a decade, so its softest point is at most this factor above the shear modulus
  // from which on all softer matrices are alike.
  constexpr double spacing = 1.4;
  const auto softest = std::ranges::min(response.snapshots, {}, [phase](const Snapshot& one) {
                         return one.moduli[phase].shear;
                       }).moduli[phase];
  const bool holds_for_softer = is_like_softer({softest.bulk, softest.shear / spacing});
  return {{(1.0 - off_bulk) * range.least.bulk, holds_for_softer ? 0.0 : (1.0 - off_shear) * range.least.shear},
          {(1.0 + off_bulk) * range.most.bulk, (1.0 + off_shear) * range.most.shear}};
}

bool is_within(double value, double least, double most) {
  return value >= least && value <= most;
}

/// Closely spaced times [s] of a window, both ends included.
std::vector<double> close_times(const TimeWindow& window) {
  constexpr double per_decade = 48.0;
  const double decades = std::log10(window.end / window.begin);
  const int count = std::max(1, static_cast<int>(std::ceil(per_decade * decades)));
  std::vector<double> times = {window.begin};
  for (int i = 1; i < count; ++i) times.push_back(window.begin * std::pow(10.0, decades * i / count));
  times.push_back(window.end);
  return times;
}

/// Adds the moduli of a phase at one time. Returns whether the response covers them.
bool covers(PhaseCoverage& of_phase, const Moduli& moduli) {
  const auto& [least, most] = of_phase.sampled;
  widen(of_phase.shown, moduli);
  const bool has_shear = is_within(moduli.shear, least.shear, most.shear);
  const bool has_bulk = is_within(moduli.bulk, least.bulk, most.bulk);
  of_phase.is_shear_covered = of_phase.is_shear_covered && has_shear;
  of_phase.is_bulk_covered = of_phase.is_bulk_covered && has_bulk;
  return has_shear && has_bulk;
}

}  // namespace

Coverage coverage(const ReducedResponse& response, std::span<const Material> of_phases, const TimeWindow& window) {
  const auto names = response.phases();
  if (of_phases.size() != names.size()) {
    throw InputError(
        fmt::format("reduced response: expected materials of {} phases, got {}", names.size(), of_phases.size()));
  }
  Coverage found;
  for (std::size_t phase = 0; phase < names.size(); ++phase) {
    found.phases.push_back({names[phase], usable_range(response, phase), empty_range()});
  }
  std::optional<TimeWindow> stretch;
  for (const double time : close_times(window)) {
    bool are_covered = true;
    for (std::size_t phase = 0; phase < names.size(); ++phase) {
      const bool is_covered = covers(found.phases[phase], carson_moduli(of_phases[phase], 1.0 / time));
      are_covered = are_covered && is_covered;
    }
    if (!are_covered) {
      stretch.reset();
      continue;
    }
    stretch = {stretch ? stretch->begin : time, time};
    if (!found.times || stretch->end / stretch->begin > found.times->end / found.times->begin) found.times = stretch;
  }
  return found;
}

double largest_error(const ReducedResponse& response, std::span<const Material> of_phases, const TimeWindow& window) {
  // Moduli are taken without a margin, only at s = 1/t of the window: moduli beyond it have less and less influence.
  constexpr double margin = 1.0;
  double error = 0.0;
  for (const auto& point : carson_path(of_phases, window, margin)) {
    error = std::max(error, response.error_estimate(point.moduli));
  }
  return error;
}

}  // namespace breccia

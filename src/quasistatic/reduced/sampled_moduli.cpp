#include "breccia/quasistatic/sampled_moduli.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "breccia/quasistatic/carson_path.hpp"

namespace breccia {
namespace {

/// Takes moduli into a range.
void widen(ModuliRange& range, const Moduli& moduli) {
  range.least = {std::min(range.least.bulk, moduli.bulk), std::min(range.least.shear, moduli.shear)};
  range.most = {std::max(range.most.bulk, moduli.bulk), std::max(range.most.shear, moduli.shear)};
}

ModuliRange empty_range() {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return {{infinite, infinite}, {-infinite, -infinite}};
}

ModuliRange usable_range(const ReducedResponse& response) {
  auto range = empty_range();
  for (const auto& snapshot : response.snapshots) widen(range, snapshot.matrix);
  // The ends of the range are snapshots, near which the error is of second order in the distance: it is below the
  // tolerance for what differs by the spacing of a path. A bulk modulus off the path costs little: the matrix is nearly
  // incompressible, or its volume matters little.
  constexpr double off_shear = 0.05, off_bulk = 0.1;
  // Eight points a decade: the last one sampled is at most that far from where all softer matrices are alike.
  constexpr double spacing = 1.4;
  const auto softest = std::ranges::min(response.snapshots, {}, [](const Snapshot& one) { return one.matrix.shear; });
  const bool holds_for_softer = is_like_softer({softest.matrix.bulk, softest.matrix.shear / spacing});
  return {{(1.0 - off_bulk) * range.least.bulk, holds_for_softer ? 0.0 : (1.0 - off_shear) * range.least.shear},
          {(1.0 + off_bulk) * range.most.bulk, (1.0 + off_shear) * range.most.shear}};
}

bool is_within(double value, double least, double most) {
  return value >= least && value <= most;
}

/// Times [s] of a window, both ends included, so close that nothing of interest lies between two.
std::vector<double> close_times(const TimeWindow& window) {
  constexpr double per_decade = 48.0;
  const double decades = std::log10(window.end / window.begin);
  const int count = std::max(1, static_cast<int>(std::ceil(per_decade * decades)));
  std::vector<double> times = {window.begin};
  for (int i = 1; i < count; ++i) times.push_back(window.begin * std::pow(10.0, decades * i / count));
  times.push_back(window.end);
  return times;
}

}  // namespace

Coverage coverage(const ReducedResponse& response, const Material& matrix, const TimeWindow& window) {
  Coverage found{usable_range(response), empty_range()};
  const auto& [least, most] = found.sampled;
  std::optional<TimeWindow> stretch;
  for (const double time : close_times(window)) {
    const auto moduli = carson_moduli(matrix, 1.0 / time);
    widen(found.shown, moduli);
    const bool has_shear = is_within(moduli.shear, least.shear, most.shear);
    const bool has_bulk = is_within(moduli.bulk, least.bulk, most.bulk);
    found.is_shear_covered = found.is_shear_covered && has_shear;
    found.is_bulk_covered = found.is_bulk_covered && has_bulk;
    if (!has_shear || !has_bulk) {
      stretch.reset();
      continue;
    }
    stretch = {stretch ? stretch->begin : time, time};
    if (!found.times || stretch->end / stretch->begin > found.times->end / found.times->begin) found.times = stretch;
  }
  return found;
}

double largest_error(const ReducedResponse& response, const Material& matrix, const TimeWindow& window) {
  // At s = 1/t of the window alone: beyond it the response counts ever less, and the estimate does not see it.
  constexpr double margin = 1.0;
  double error = 0.0;
  for (const auto& moduli : carson_path(matrix, window, margin)) {
    error = std::max(error, response.error_estimate(moduli));
  }
  return error;
}

}  // namespace breccia

#include "quasistatic/reduced/greedy_sampling.hpp"

#include <algorithm>
#include <limits>

namespace breccia::quasistatic {

bool are_equal(std::span<const Moduli> some, std::span<const Moduli> others) {
  return std::ranges::equal(some, others, [](const Moduli& one, const Moduli& other) {
    return one.bulk == other.bulk && one.shear == other.shear;
  });
}

std::vector<std::vector<Moduli>> initial_snapshots(const TrainingPath& training_set) {
  const auto& points = training_set.points;
  std::vector<std::vector<Moduli>> initial = {points[points.size() / 2]};
  for (const auto& end : {points.front(), points.back()}) {
    if (!are_equal(end, initial.front())) initial.push_back(end);
  }
  return initial;
}

void require_complete(std::span<const Load> loads, const TrainingPath& training_set) {
  if (training_set.points.empty()) throw InputError("reduced basis: no moduli to sample");
  const auto phases = training_set.phases.size();
  for (const auto& point : training_set.points) {
    if (point.size() == phases) continue;
    throw InputError(
        fmt::format("reduced basis: expected the moduli of {} phases at each point of the training set, "
                    "got those of {}",
                    phases, point.size()));
  }
  if (loads.empty()) throw InputError("reduced basis: no loads");
}

void require_useful(double error, const TrainingPath& training_set, const SamplingOptions& options) {
  constexpr double most = 0.1;
  if (error <= std::max(most, options.tolerance)) return;
  double softest = std::numeric_limits<double>::infinity(), stiffest = 0.0;
  for (const auto& point : training_set.points) {
    for (const auto& [bulk, shear] : point) {
      if (shear > 0.0) softest = std::min(softest, shear);
      stiffest = std::max({stiffest, bulk, shear});
    }
  }
  throw NumericalError(fmt::format(
      "reduced basis: the error is still {:.1e} after {} snapshots, wanted {:.1e}; the sampled moduli go from "
      "{:.2g} to {:.2g} Pa (is a unit of one of them wrong?); tests.quasistatic.range = \"times\" takes fewer of them, "
      "and tests.solver = \"stepping\" has no basis",
      error, options.most_snapshots, options.tolerance, softest, stiffest));
}

}  // namespace breccia::quasistatic

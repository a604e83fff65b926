#include "quasistatic/stepping/log_time_runs.hpp"

#include <cmath>

#include "breccia/error.hpp"

namespace breccia::quasistatic {
namespace {

/// Relative errors of the fine run. The method is of second order, so the error of the fine run is a third of its
/// difference to the coarse run. A time between two times of the coarse run has the larger of their estimates.
std::vector<double> error_estimates(const std::vector<double>& fine, const std::vector<double>& coarse,
                                    const std::vector<std::size_t>& indices) {
  std::vector<double> errors(fine.size(), 0.0);
  for (std::size_t c = 0; c < indices.size(); ++c) {
    const double error = std::abs(coarse[c] / fine[indices[c]] - 1.0) / 3.0;
    const std::size_t before = c == 0 ? 0 : indices[c - 1] + 1;
    const std::size_t behind = c + 1 == indices.size() ? fine.size() : indices[c + 1];
    for (std::size_t i = before; i < behind; ++i) errors[i] = std::max(errors[i], error);
  }
  return errors;
}

}  // namespace

std::vector<std::size_t> every_other(std::size_t count) {
  std::vector<std::size_t> coarse;
  for (std::size_t i = 1; i < count; i += 2) coarse.push_back(i);
  if (count % 2 == 1) coarse.push_back(count - 1);
  return coarse;
}

std::vector<double> at_indices(std::span<const double> values, const std::vector<std::size_t>& indices) {
  std::vector<double> chosen;
  chosen.reserve(indices.size());
  for (const auto index : indices) chosen.push_back(values[index]);
  return chosen;
}

SteppedResponse stepped_response(Load load, const std::vector<double>& fine, const std::vector<double>& coarse,
                                 const std::vector<std::size_t>& indices) {
  const std::vector values(fine.begin() + 1, fine.end());
  return {load, fine.front(), values, error_estimates(values, {coarse.begin() + 1, coarse.end()}, indices)};
}

void require_steps(std::span<const Load> loads, std::span<const double> times) {
  const auto is_time = [](double time) { return time > 0.0 && std::isfinite(time); };
  const auto rises = [](double before, double after) { return before < after; };
  if (times.empty() || !std::ranges::all_of(times, is_time) ||
      std::ranges::adjacent_find(times, std::not_fn(rises)) != times.end()) {
    throw InputError("log-time stepping: expected rising positive times");
  }
  if (loads.empty()) throw InputError("log-time stepping: no loads");
}

}  // namespace breccia::quasistatic

#include "breccia/homogenisation/grid_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

/// Theory, Eq. 43a: the error with c cells in the narrowest gap is at most about error_of_one c^-order.
struct ErrorRule {
  double error_of_one;  ///< [-]
  double order;         ///< [-]
  double least_cells;   ///< below them the rule does not hold
};

constexpr ErrorRule rule_of(Mixing mixing) {
  return mixing == Mixing::series ? ErrorRule{0.10, 1.8, 1.0} : ErrorRule{3.0, 1.35, 3.0};
}

}  // namespace

std::optional<double> expected_grid_error(Mixing mixing, double cells_per_gap) {
  constexpr double rounding = 1e-9;
  const auto rule = rule_of(mixing);
  if (cells_per_gap < rule.least_cells * (1.0 - rounding)) return std::nullopt;
  return rule.error_of_one * std::pow(cells_per_gap, -rule.order);
}

double cells_per_gap_for(Mixing mixing, double error) {
  const auto rule = rule_of(mixing);
  return std::max(rule.least_cells, std::pow(rule.error_of_one / error, 1.0 / rule.order));
}

}  // namespace breccia

#include "breccia/homogenisation/grid_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

/// The error with c cells in the narrowest gap, or across a mean sphere, is at most about error_of_one c^-order.
struct ErrorRule {
  double error_of_one;  ///< [-]
  double order;         ///< [-]
  double least_cells;   ///< below them the rule does not hold

  [[nodiscard]] std::optional<double> error_with(double cells) const {
    constexpr double rounding = 1e-9;
    if (cells < least_cells * (1.0 - rounding)) return std::nullopt;
    return error_of_one * std::pow(cells, -order);
  }
  [[nodiscard]] double cells_for(double error) const {
    return std::max(least_cells, std::pow(error_of_one / error, 1.0 / order));
  }
};

/// Theory, Eq. 43a.
constexpr ErrorRule rule_of(Mixing mixing) {
  return mixing == Mixing::series ? ErrorRule{0.10, 1.8, 1.5} : ErrorRule{3.0, 1.35, 3.0};
}

/// Theory, Eq. 43b.
constexpr ErrorRule rule_of_films = {0.15, 1.25, 2.4};

/// Theory, Eq. 43c: what the grid does to the spheres counts the more the closer they are to jamming.
std::optional<ErrorRule> rule_of_spheres(double fraction) {
  constexpr double jammed = 0.70, largest = 0.60;
  if (fraction > largest) return std::nullopt;
  return ErrorRule{0.63 / (jammed - fraction), 1.65, 4.5};
}

}  // namespace

std::optional<double> expected_grid_error(Mixing mixing, double cells_per_gap) {
  return rule_of(mixing).error_with(cells_per_gap);
}

double cells_per_gap_for(Mixing mixing, double error) {
  return rule_of(mixing).cells_for(error);
}

std::optional<double> expected_film_error(double cells_per_film) {
  return rule_of_films.error_with(cells_per_film);
}

double cells_per_film_for(double error) {
  return rule_of_films.cells_for(error);
}

std::optional<double> expected_sphere_error(double cells_per_diameter, double fraction) {
  const auto rule = rule_of_spheres(fraction);
  return rule ? rule->error_with(cells_per_diameter) : std::nullopt;
}

std::optional<double> cells_per_diameter_for(double error, double fraction) {
  const auto rule = rule_of_spheres(fraction);
  return rule ? std::optional(rule->cells_for(error)) : std::nullopt;
}

bool is_sphere_error_measured(double fraction) {
  constexpr double least = 0.30, most = 0.50, about = 0.02;
  return fraction > least - about && fraction < most + about;
}

}  // namespace breccia

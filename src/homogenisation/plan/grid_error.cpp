#include "homogenisation/plan/grid_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>

#include "homogenisation/narrow_gaps.hpp"
#include "study/chain.hpp"

namespace breccia {
namespace {

/// A characteristic length of the microstructure: the error of a grid depends on the number of cells along it.
struct ResolvedLength {
  double length;  ///< [m]
  std::string_view place;
  std::optional<ErrorRule> rule = {};
  std::string_view without_rule = {};
};

/// Whether the rule of spheres was measured near this fraction [-]; otherwise it is extrapolated.
bool is_measured(double fraction) {
  constexpr double least = 0.30, most = 0.50, about = 0.02;
  return fraction > least - about && fraction < most + about;
}

ResolvedLength length_of_spheres(const Stage& stage, const StageMicrostructure& packed) {
  const double diameter = packed.mean_diameter();
  if (has_spheres_that_almost_touch(stage, packed)) {
    return {diameter, "across the mean sphere", {}, "spheres that almost touch, in series"};
  }
  const auto rule = error_rule_of_spheres(packed.fraction);
  const auto* place = is_measured(packed.fraction)
                          ? "across the mean sphere"
                          : "across the mean sphere, by a rule that is extrapolated from 30 to 50 % of spheres";
  return {diameter, place, rule, "spheres close to jamming"};
}

/// The smallest particle of discs, spheres or particles of other shapes: a visitor of the content of a box. Nothing for
/// another content.
struct SmallestParticle {
  template <int dim>
  std::optional<ResolvedLength> operator()(const Microstructure<dim>& balls) const {
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& ball : balls.particles) smallest = std::min(smallest, ball.diameter);
    return ResolvedLength{
        smallest,
        dim == 2 ? "across the smallest disc" : "across the smallest sphere, by a rule of packings of 52 and 55 %",
        error_rule_of_flow(dim)};
  }
  std::optional<ResolvedLength> operator()(const ParticleBox& box) const {
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& particle : box.particles) smallest = std::min(smallest, equivalent_diameter(particle.shape));
    return ResolvedLength{smallest, "across the smallest particle", error_rule_of_flow(2)};
  }
  template <class Other>
  std::optional<ResolvedLength> operator()(const Other&) const {
    return std::nullopt;
  }
};

/// The number of spheres of the packings with which the rule of flow in space was measured.
constexpr std::size_t fewest_of_packing = 8;

ResolvedLength resolved_length(const Stage& stage, const StageMicrostructure& packed, Mixing mixing) {
  const double gap = std::min(packed.gap, packed.wall_gap);
  if (packed.grains() != nullptr) {
    if (mixing == Mixing::flow) return {gap, "across a film", error_rule_of_narrow_films()};
    return {gap, "across a film", error_rule_of_films()};
  }
  if (mixing == Mixing::flow) {
    if (auto length = visit_nested(SmallestParticle(), packed.box)) {
      const bool is_regular = stage.packed_by<LatticePacking>() != nullptr || packed.particles() < fewest_of_packing;
      if (stage.dimensions() == 2 || !is_regular) return *length;
      return {length->length, "across the smallest sphere", {}, "lattices and a few spheres with flow through gaps"};
    }
  }
  constexpr auto in_a_gap = "in the narrowest gap";
  if (stage.dimensions() == 2) return {gap, in_a_gap, error_rule_of_gaps(mixing)};
  if (mixing == Mixing::points) return {gap, in_a_gap, {}, "points in three dimensions"};
  if (packed.content<Microstructure<3>>() == nullptr) return {gap, in_a_gap, {}, "ellipsoids"};
  return length_of_spheres(stage, packed);
}

/// The plan of the finest grid, by the cells along a length; nothing without such a length.
std::optional<GridPlan> plan_along(const ResolvedLength& resolved, const Stage& stage) {
  const auto& [length, place, rule, without_rule] = resolved;
  if (!std::isfinite(length) || !(length > 0.0)) return std::nullopt;
  return GridPlan{.cell_size = stage.cell_size(),
                  .side = stage.side,
                  .length = length,
                  .place = place,
                  .rule = rule,
                  .without_rule = rule ? std::string_view() : without_rule};
}

}  // namespace

ErrorRule error_rule_of_gaps(Mixing mixing) {
  return has_mixed_cells(mixing) ? ErrorRule{0.10, 1.8, 1.5} : ErrorRule{3.0, 1.35, 3.0};
}

ErrorRule error_rule_of_flow(int dimensions) {
  return dimensions == 2 ? ErrorRule{0.5, 1.0, 8.0} : ErrorRule{0.45, 0.6, 7.0, 20.0};
}

ErrorRule error_rule_of_films() {
  return {0.15, 1.25, 2.4};
}

ErrorRule error_rule_of_narrow_films() {
  return {0.1, 1.0, 0.3, 1.4};
}

// The error of the grid grows as the spheres come closer to jamming.
std::optional<ErrorRule> error_rule_of_spheres(double fraction) {
  constexpr double jammed = 0.70, largest = 0.60;
  if (fraction > largest) return std::nullopt;
  return ErrorRule{0.63 / (jammed - fraction), 1.65, 4.5};
}

double steepest_fall(const PronySeries& modulus, const TimeWindow& window) {
  constexpr int per_decade = 10;
  double steepest = 0.0;
  for (const double time : logarithmic_times(window, per_decade)) {
    double fall = 0.0;
    for (const auto& [tau, strength] : modulus.terms()) fall += strength * time / tau * std::exp(-time / tau);
    const double left = modulus.at(time);
    if (left > 0.0) {
      steepest = std::max(steepest, fall / left);
    } else if (!modulus.is_elastic()) {
      // Less than numbers hold is left, of the slowest term, which is the first.
      steepest = std::max(steepest, time / modulus.terms().front().relaxation_time);
    }
  }
  return steepest;
}

std::optional<GridPlan> plan_of_grid(const Stage& stage, const StageMicrostructure& packed, Mixing mixing) {
  const bool is_extrapolated = mixing == Mixing::points && !stage.coarser_cells.empty();
  // Between grains no rule is known for points, which take far more cells.
  const bool has_no_rule = mixing == Mixing::points && packed.grains() != nullptr;
  if (is_extrapolated || has_no_rule) return std::nullopt;
  return plan_along(resolved_length(stage, packed, mixing), stage);
}

std::optional<GridPlan> plan_of_grid(const Study& study, const Stage& stage, const StageMicrostructure& packed) {
  const auto mixing = mixing_of(study, stage, packed);
  const bool are_soft_in_plane = stage.dimensions() == 2 && has_mixed_cells(mixing) && has_soft_fillers(study, stage);
  const auto particle = are_soft_in_plane ? visit_nested(SmallestParticle(), packed.box) : std::nullopt;
  auto plan = particle ? plan_along(*particle, stage) : plan_of_grid(stage, packed, mixing);
  if (!plan || !plan->rule) return plan;
  constexpr double steepest_with_rule = 2.0;
  const double fall = steepest_fall(binder_of(study, stage).shear, {study.tests.first_time, study.tests.last_time});
  plan->rule->error_of_one *= std::max(1.0, fall);
  if (fall > steepest_with_rule) {
    plan->rule.reset();
    plan->without_rule = "a binder that falls faster than 1/t^2";
  }
  return plan;
}

}  // namespace breccia

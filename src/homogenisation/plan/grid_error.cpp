#include "homogenisation/plan/grid_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <variant>

#include "discretisation/contrast.hpp"
#include "homogenisation/narrow_gaps.hpp"
#include "homogenisation/run/test_requests.hpp"
#include "study/chain.hpp"
#include "study/coatings.hpp"

namespace breccia {
namespace {

/// A characteristic length of the microstructure: the error of a grid depends on the number of cells along it.
struct ResolvedLength {
  double length;  ///< [m]
  std::string_view place;
  std::optional<ErrorRule> rule = {};
  std::string_view caveat = {};
  std::string_view without_rule = {};
  double interfaces = 0.0;  ///< as GridPlan::interfaces [1/m]
};

/// Whether particles were placed at random, as many at least as in the packings with which rules were measured.
/// Lattices err more, and a few particles in a periodic box, or listed ones, may be a lattice.
bool is_random_packing(const Stage& stage, const StageMicrostructure& packed) {
  constexpr std::size_t fewest = 8;
  return stage.has_seed() && packed.particles() >= fewest;
}

constexpr std::string_view other_than_random = "lattices, lists of particles and boxes of fewer than eight";

/// Whether the rule of spheres was measured near this fraction [-]; otherwise it is extrapolated.
bool is_measured(double fraction) {
  constexpr double least = 0.30, most = 0.50, about = 0.02;
  return fraction > least - about && fraction < most + about;
}

ResolvedLength length_of_spheres(const Stage& stage, const StageMicrostructure& packed) {
  ResolvedLength resolved{packed.mean_diameter(), "across the mean sphere"};
  if (!is_random_packing(stage, packed)) {
    resolved.without_rule = other_than_random;
  } else if (has_spheres_that_almost_touch(stage, packed)) {
    resolved.without_rule = "spheres that almost touch, in series";
  } else if (resolved.rule = error_rule_of_spheres(packed.fraction); !resolved.rule) {
    resolved.without_rule = "spheres close to jamming";
  } else {
    resolved.rule->least_cells = std::max(resolved.rule->least_cells, least_cells_across_spheres(packed));
    if (!is_measured(packed.fraction)) resolved.caveat = "that is extrapolated from 30 to 50 % of spheres";
  }
  return resolved;
}

/// The smallest particle of discs, spheres or particles of other shapes: a visitor of the content of a box. Nothing for
/// another content.
struct SmallestParticle {
  std::optional<ResolvedLength> operator()(const Microstructure<2>& discs) const {
    return ResolvedLength{smallest_of(discs), "across the smallest disc", error_rule_of_discs()};
  }
  std::optional<ResolvedLength> operator()(const Microstructure<3>& spheres) const {
    return ResolvedLength{smallest_of(spheres), "across the smallest sphere", error_rule_of_spheres_with_flow(),
                          "of packings of 52 and 55 %"};
  }
  std::optional<ResolvedLength> operator()(const ParticleBox& box) const {
    double smallest = std::numeric_limits<double>::infinity();
    bool has_polygons = false;
    for (const auto& particle : box.particles) {
      smallest = std::min(smallest, equivalent_diameter(particle.shape));
      has_polygons = has_polygons || std::holds_alternative<ConvexPolygon>(particle.shape);
    }
    return ResolvedLength{smallest, "across the smallest particle",
                          has_polygons ? error_rule_of_polygons() : error_rule_of_discs()};
  }
  template <class Other>
  std::optional<ResolvedLength> operator()(const Other&) const {
    return std::nullopt;
  }

 private:
  template <int dim>
  static double smallest_of(const Microstructure<dim>& balls) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& ball : balls.particles) smallest = std::min(smallest, ball.diameter);
    return smallest;
  }
};

/// The smallest particle, and the rule for the cells across it where the packing is like those that were measured.
std::optional<ResolvedLength> length_of_smallest(const Stage& stage, const StageMicrostructure& packed) {
  auto resolved = visit_nested(SmallestParticle(), packed.box);
  if (!resolved) return std::nullopt;
  constexpr double most_of_spheres = 0.6;
  if (!is_random_packing(stage, packed)) {
    resolved->without_rule = other_than_random;
  } else if (has_particles_that_touch(stage, packed)) {
    resolved->without_rule = "particles that touch, or almost";
  } else if (stage.dimensions() == 3 && packed.fraction > most_of_spheres) {
    resolved->without_rule = "spheres close to jamming";
  }
  if (!resolved->without_rule.empty()) resolved->rule.reset();
  return resolved;
}

ResolvedLength resolved_length(const Stage& stage, const StageMicrostructure& packed, Mixing mixing) {
  const double gap = std::min(packed.gap, packed.wall_gap);
  if (packed.grains() != nullptr) {
    if (mixing == Mixing::flow) return {gap, "across a film", error_rule_of_narrow_films()};
    return {gap, "across a film", error_rule_of_films()};
  }
  if (mixing == Mixing::flow) {
    if (auto length = length_of_smallest(stage, packed)) return *length;
  }
  constexpr auto in_a_gap = "in the narrowest gap";
  if (stage.dimensions() == 2) {
    // Wider gaps do not make the particles easier to resolve. The gaps of an image are not known.
    const double widest = std::isfinite(gap) ? 0.5 * packed.mean_diameter() : gap;
    ResolvedLength resolved{std::min(gap, widest), gap > widest ? "across half of the mean particle" : in_a_gap,
                            error_rule_of_gaps(mixing)};
    if (has_mixed_cells(mixing)) resolved.interfaces = error_of_interfaces(packed.fraction) / packed.mean_diameter();
    return resolved;
  }
  if (mixing == Mixing::points) return {gap, in_a_gap, {}, {}, "points in three dimensions"};
  if (packed.content<Microstructure<3>>() == nullptr) return {gap, in_a_gap, {}, {}, "ellipsoids"};
  return length_of_spheres(stage, packed);
}

/// The reason why the materials of a stage have no rule; empty where they may have one.
std::string_view materials_without_rule(const Study& study, const Stage& stage, Mixing mixing) {
  constexpr double least_cells = 2.0, rounding = 1e-9;
  if (!has_mixed_cells(mixing)) return {};
  if (stage.has_crystals()) return "crystals, whose surfaces have their isotropic means";
  const auto coating = thinnest_coating(stage);
  if (coating && *coating < least_cells * stage.cell_size() * (1.0 - rounding))
    return "coatings of less than two cells";
  if (are_stiffer_than_matrix(materials_of(stage, expected_matrix(study, stage)))) return {};
  const bool are_soft = has_soft_fillers(study, stage);
  if (!are_soft) return "fillers or coatings that are neither stiffer nor softer than the matrix at all times";
  if (stage.has_grains()) return "grains that are softer than the matrix";
  return stage.dimensions() == 3 ? "fillers that are softer than the matrix, in three dimensions" : std::string_view();
}

}  // namespace

ErrorRule error_rule_of_gaps(Mixing mixing) {
  return has_mixed_cells(mixing) ? ErrorRule{0.10, 1.8, 1.5} : ErrorRule{3.0, 1.35, 3.0};
}

double error_of_interfaces(double fraction) {
  return 1.3 * fraction;
}

ErrorRule error_rule_of_discs() {
  return {0.5, 1.0, 8.0};
}

ErrorRule error_rule_of_polygons() {
  return {1.0, 1.0, 8.0};
}

ErrorRule error_rule_of_spheres_with_flow() {
  return {0.45, 0.6, 7.0, 20.0};
}

ErrorRule error_rule_of_films() {
  return {0.15, 1.25, 2.4};
}

ErrorRule error_rule_of_narrow_films() {
  return {0.1, 1.0, 0.3, 1.4};
}

// The error of the grid grows as the spheres come closer to jamming.
std::optional<ErrorRule> error_rule_of_spheres(double fraction) {
  constexpr double jammed = 0.70, largest = 0.60, finest_measured = 20.0;
  if (fraction > largest) return std::nullopt;
  return ErrorRule{0.63 / (jammed - fraction), 1.65, 4.5, finest_measured};
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

std::optional<GridPlan> plan_of_grid(const Study& study, const Stage& stage, const StageMicrostructure& packed) {
  const auto mixing = mixing_of(study, stage, packed);
  const bool is_extrapolated = mixing == Mixing::points && !stage.coarser_cells.empty();
  // Between grains no rule is known for points, which take far more cells.
  const bool has_no_rule = mixing == Mixing::points && packed.grains() != nullptr;
  if (is_extrapolated || has_no_rule) return std::nullopt;
  const bool are_soft_in_plane = stage.dimensions() == 2 && has_mixed_cells(mixing) && has_soft_fillers(study, stage);
  const auto soft = are_soft_in_plane ? length_of_smallest(stage, packed) : std::nullopt;
  auto resolved = soft ? *soft : resolved_length(stage, packed, mixing);
  if (!std::isfinite(resolved.length) || !(resolved.length > 0.0)) return std::nullopt;

  const double fall = steepest_fall(binder_of(study, stage).shear, {study.tests.first_time, study.tests.last_time});
  if (resolved.rule) {
    resolved.rule->error_of_one *= std::max(1.0, fall);
    resolved.interfaces *= std::max(1.0, fall);
    resolved.without_rule = fall > steepest_fall_with_rule ? "a binder that falls faster than 1/t^2"
                                                           : materials_without_rule(study, stage, mixing);
    if (!resolved.without_rule.empty()) resolved.rule.reset();
  }
  return GridPlan{.cell_size = stage.cell_size(),
                  .side = stage.side,
                  .length = resolved.length,
                  .place = resolved.place,
                  .rule = resolved.rule,
                  .interfaces = resolved.interfaces,
                  .caveat = resolved.caveat,
                  .without_rule = resolved.without_rule};
}

}  // namespace breccia

#include "homogenisation/plan/box_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <variant>

#include "breccia/homogenisation/stage_microstructure.hpp"

#include "homogenisation/modulus_errors.hpp"
#include "homogenisation/narrow_gaps.hpp"
#include "homogenisation/plan/cell_memory.hpp"
#include "homogenisation/plan/cell_time.hpp"
#include "homogenisation/plan/expected_sample_error.hpp"
#include "homogenisation/plan/film_costs.hpp"
#include "homogenisation/plan/film_error.hpp"
#include "homogenisation/plan/grid_error.hpp"
#include "study/chain.hpp"
#include "study/effective_particles.hpp"
#include "study/filler_sizes.hpp"
#include "study/limits.hpp"
#include "study/side_of_particles.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

/// Cells of one size and the error of a grid of them.
struct CellSize {
  double length;  ///< [m]
  double error;   ///< [-]
};

/// A box and a grid that may be chosen.
struct Option {
  double particles = 0.0;
  CellSize cell = {};
  bool has_rule = true;                                      ///< whether the error of the grid is known
  double error = std::numeric_limits<double>::infinity();    ///< of grid and sample [-]
  double seconds = std::numeric_limits<double>::infinity();  ///< processor time [s]
};

/// The packing with the seed 1, so that the choice is the same for all seeds.
StagePacking with_first_seed(StagePacking packing) {
  const auto set = [](auto& method) {
    if constexpr (requires { method.seed; }) method.seed = 1;
  };
  std::visit([&](auto& of_dimension) { std::visit(set, of_dimension); }, packing);
  return packing;
}

/// Whether the particles of one filler have different sizes.
bool has_wide_filler(const Stage& stage) {
  return std::ranges::any_of(stage.fillers, [](const Filler& filler) {
    const auto range = diameters_of(filler);
    return range && range->smallest < range->largest;
  });
}

/// Chooses the box and the grid of one stage by means of a box with few particles.
class Chooser {
 public:
  Chooser(const Study& study, const Stage& stage, const AccuracyGoal& goal, int particles_of_pilot)
      : study_(study), stage_(stage), goal_(goal), has_films_(model_of(study.tests, stage) == Model::films) {
    in_series_ = study;
    in_series_.tests.mixing = Mixing::series;
    const bool is_of_space = stage.dimensions() == 3;
    pilot_ = stage;
    if (is_box_free()) {
      pilot_.packing = with_first_seed(stage.packing);
      pilot_.side = side_of_particles(stage, particles_of_pilot);
    }
    if (pilot_.cells == 0) pilot_.cells = few_cells;
    // Debonded films have no rule, and listed ones are those of the whole box: the box is chosen as if all were bonded.
    pilot_.bonds.reset();
    packed_ = make_microstructure(pilot_);
    // The narrowest of many gaps is no wider than what the deck asks for.
    for (const auto& filler : stage.fillers) {
      if (filler.gap > 0.0) packed_.gap = std::min(packed_.gap, filler.gap);
    }
    scatter_ = scatter_of_one();
    if (is_box_free() && !stage.has_grains() && has_wide_filler(stage)) wide_ = effective_particles_of(stage);
    sizes_ = sizes_of_cells();
    // Boxes of which nothing is known are as large as that of the starter deck.
    fewest_ = scatter_ || wide_ ? std::ceil(fewest_effective / share_of_effective()) : is_of_space ? 32.0 : 64.0;
    fewest_ = std::min(fewest_, most_particles);
    if (is_box_free()) fewest_ = std::max(fewest_, static_cast<double>(fewest_particles(stage)));
  }

  /// Gives the stage its box and its grid.
  BoxChoice choose(Stage& stage) const {
    const auto cheapest = is_box_free() ? cheapest_that_reaches() : coarsest_in_given_box();
    const auto chosen = is_affordable(cheapest) ? cheapest : best_affordable();
    BoxChoice choice = {.stage = stage.name, .goal = goal_.error, .budget = goal_.seconds};
    if (is_box_free()) {
      choice.particles = static_cast<int>(std::lround(chosen.particles));
      stage.side = side_of_particles(stage, choice.particles);
    }
    if (stage.cells == 0) {
      stage.cells = even_cells(stage.side / chosen.cell.length);
      if (!chosen.has_rule) stage.coarser_cells = {stage.cells / 2};
    }
    if (has_films_) {
      choice.grid = stage_.bonds ? std::nullopt : film_error(study_, pilot_, packed_);
    } else if (chosen.has_rule) {
      choice.grid = grid_error(stage);
    }
    if (scatter_ && !stage_.bonds) choice.sample = *scatter_ / std::sqrt(share_of_effective() * chosen.particles);
    choice.seconds = seconds_of(chosen.particles, chosen.cell.length);
    if (cheapest.error <= goal_.error) {
      choice.seconds_of_goal = cheapest.seconds;
      choice.bytes_of_goal = bytes_of(cheapest.particles, cheapest.cell.length);
    }
    return choice;
  }

 private:
  static constexpr int few_cells = 2;

  [[nodiscard]] bool is_box_free() const { return stage_.side == 0.0; }

  static int even_cells(double cells) {
    return 2 * static_cast<int>(std::ceil(0.5 * std::clamp(cells, allowed::cells.lower, allowed::cells.upper)));
  }

  [[nodiscard]] double particles_of_pilot() const { return std::max(1.0, static_cast<double>(packed_.particles())); }

  /// The effective number of particles over their number [-]. The box of the pilot is too small to have the largest
  /// ones of a wide distribution.
  [[nodiscard]] double share_of_effective() const {
    if (wide_) return wide_->share;
    return packed_.effective_particles > 0.0 ? packed_.effective_particles / particles_of_pilot() : 1.0;
  }

  /// The expected error of the sample, times the root of the effective number of its particles.
  [[nodiscard]] std::optional<double> scatter_of_one() const {
    // The stiffening of the boxes that were compared was up to an eighth larger than expected.
    constexpr double many = 1e6, margin = 1.12;
    auto rules = error_rules_of(study_, pilot_, packed_);
    if (rules.sample == SampleKind::whole) return 0.0;
    rules.effective_particles = many;
    const auto error = expected_sample_error(study_, pilot_, packed_.fillers, rules);
    return error ? std::optional(margin * *error * std::sqrt(many)) : std::nullopt;
  }

  [[nodiscard]] std::optional<double> grid_error(const Stage& stage) const {
    const auto plan = plan_of_grid(study_, stage, packed_);
    return plan ? plan->error() : std::nullopt;
  }

  /// Cells from coarse to fine, each with a smaller error than all before; none where no rule gives it.
  [[nodiscard]] std::vector<CellSize> sizes_of_cells() const {
    constexpr double finest = 400.0, ratio = 1.06;
    const double diameter = packed_.mean_diameter();
    if (has_films_) return {{diameter, film_error(study_, pilot_, packed_).value_or(0.0)}};
    std::vector<CellSize> sizes;
    auto trial = pilot_;
    for (double across = fewest_across; across < finest; across *= ratio) {
      trial.cells = even_cells(across * pilot_.side / diameter);
      const auto error = grid_error(trial);
      if (error && (sizes.empty() || *error < sizes.back().error)) sizes.push_back({trial.cell_size(), *error});
    }
    return sizes;
  }

  /// The stage with so many particles in its box and cells of this length [m].
  [[nodiscard]] Stage stage_with(double particles, double length) const {
    auto stage = pilot_;
    stage.side *= std::pow(particles / particles_of_pilot(), 1.0 / stage.dimensions());
    if (stage_.cells == 0) stage.cells = even_cells(stage.side / length);
    return stage;
  }

  /// The study with the mixing that the cells of a stage have.
  [[nodiscard]] const Study& as_computed(const Stage& stage) const {
    return mixing_of(study_, stage, packed_) == study_.tests.mixing ? study_ : in_series_;
  }

  [[nodiscard]] double seconds_of(double particles, double length) const {
    const auto stage = stage_with(particles, length);
    const auto boundaries = static_cast<double>(study_.tests.boundaries.size());
    if (has_films_) return boundaries * film_time(study_, stage, expected_grains(stage));
    const auto& study = as_computed(stage);
    double seconds = discretisation_time(study, stage, stage.cells);
    for (const auto boundary : study.tests.boundaries) {
      seconds += quasistatic_time(study, stage, boundary, stage.cells);
    }
    return seconds;
  }

  [[nodiscard]] double bytes_of(double particles, double length) const {
    const auto stage = stage_with(particles, length);
    return has_films_ ? film_memory(study_, stage, expected_grains(stage))
                      : quasistatic_memory(as_computed(stage), stage, stage.cells);
  }

  [[nodiscard]] bool is_affordable(const Option& option) const {
    return option.seconds <= goal_.seconds && bytes_of(option.particles, option.cell.length) <= most_bytes_of_choice;
  }

  [[nodiscard]] Option option_with(double particles, const CellSize& cell) const {
    const double sample = scatter_.value_or(0.0) / std::sqrt(share_of_effective() * particles);
    return {.particles = particles,
            .cell = cell,
            .error = std::hypot(cell.error, sample),
            .seconds = seconds_of(particles, cell.length)};
  }

  /// The fewest particles whose sample has this error at most.
  [[nodiscard]] double particles_for(double error) const {
    const double root = scatter_.value_or(0.0) / error;
    return std::max(fewest_, std::ceil(root * root / share_of_effective()));
  }

  /// The option that reaches the goal in the least time, where 4 GB of memory count as much as twice the time; an
  /// infinite time where none does.
  [[nodiscard]] Option cheapest_that_reaches() const {
    constexpr double bytes_like_twice_the_time = 4e9;
    Option cheapest;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& cell : sizes_) {
      const double left = goal_.error * goal_.error - cell.error * cell.error;
      if (!(left > 0.0)) continue;
      const double particles = particles_for(std::sqrt(left));
      if (particles > most_particles) continue;
      const auto option = option_with(particles, cell);
      const double cost = option.seconds * (1.0 + bytes_of(particles, cell.length) / bytes_like_twice_the_time);
      if (cost < least) cheapest = option;
      least = std::min(least, cost);
    }
    return cheapest;
  }

  /// The coarsest cells that reach the goal with the particles of a given box. Where these scatter too much for that,
  /// those that have their share of it.
  [[nodiscard]] Option coarsest_in_given_box() const {
    const double particles = particles_of_pilot(), goal = goal_.error * goal_.error;
    const double sample = scatter_.value_or(0.0) / std::sqrt(share_of_effective() * particles);
    const double left = std::max(goal - sample * sample, 0.5 * goal);
    const auto fine =
        std::ranges::find_if(sizes_, [left](const CellSize& cell) { return cell.error * cell.error <= left; });
    return fine == sizes_.end() ? Option() : option_with(particles, *fine);
  }

  /// The option with the least error within the time and the memory.
  [[nodiscard]] Option best_affordable() const {
    Option best;
    for (const auto& cell : sizes_) {
      const auto option = option_with(is_box_free() ? affordable_particles(cell) : particles_of_pilot(), cell);
      if (is_affordable(option) && option.error < best.error) best = option;
    }
    return std::isfinite(best.seconds) ? best : finest_without_rule();
  }

  /// Cells that are usually fine enough, or else the finest within the time and the memory. Where the coarsest are not
  /// within them, a box that has too few of the largest particles, of which there is a warning.
  [[nodiscard]] Option finest_without_rule() const {
    constexpr double usual = 20.0, ratio = 1.06, smaller = 1.2;
    double particles = is_box_free() ? fewest_ : particles_of_pilot();
    Option option;
    for (double across = usual; across >= fewest_across; across /= ratio) {
      option = option_with(particles, {packed_.mean_diameter() / across, 0.0});
      if (is_affordable(option)) break;
    }
    while (wide_ && !is_affordable(option) && particles > smaller * particles_of_pilot()) {
      particles /= smaller;
      option = option_with(particles, option.cell);
    }
    option.has_rule = has_films_;
    return option;
  }

  /// The most particles within the time and the memory, of a wide distribution also fewer than have room for its
  /// largest ones, of which there is a warning; where the scatter has no rule, no more than usual, and where the error
  /// of films is above the goal, no more than have the same error.
  [[nodiscard]] double affordable_particles(const CellSize& cell) const {
    const bool is_too_wide = wide_ && !is_affordable(option_with(fewest_, cell));
    const double fewest = is_too_wide ? std::min(fewest_, particles_of_pilot()) : fewest_;
    if (!scatter_ || *scatter_ == 0.0 || !is_affordable(option_with(fewest, cell))) return fewest;
    double low = fewest, high = is_too_wide ? fewest_ : most_particles;
    if (has_films_ && cell.error > goal_.error) high = std::clamp(particles_for(cell.error), low, high);
    constexpr double precise = 1.01;
    while (high > precise * low) {
      const double middle = std::sqrt(low * high);
      (is_affordable(option_with(middle, cell)) ? low : high) = middle;
    }
    return std::floor(is_affordable(option_with(high, cell)) ? high : low);
  }

  static constexpr double most_particles = 1e5, fewest_across = 4.0;

  const Study& study_;
  Study in_series_ = {};
  const Stage& stage_;
  AccuracyGoal goal_;
  bool has_films_;
  Stage pilot_;
  StageMicrostructure packed_ = {};
  std::optional<double> scatter_ = {};
  std::optional<EffectiveParticles> wide_ = {};  ///< where the sizes of a filler are a distribution
  std::vector<CellSize> sizes_ = {};
  double fewest_ = 0.0;
};

/// The number of stages in the longest chain of stages that are the matrix of the next one.
std::size_t longest_chain(const Study& study) {
  std::size_t longest = 1;
  for (const auto& stage : study.stages) {
    std::size_t length = 1;
    for (const auto* below = stage_of_matrix(study, stage); below != nullptr; below = stage_of_matrix(study, *below)) {
      ++length;
    }
    longest = std::max(longest, length);
  }
  return longest;
}

/// Whether the particles of a stage have different sizes.
bool has_distribution(const Stage& stage) {
  const auto range = diameters_of(stage);
  return range && range->smallest < range->largest;
}

}  // namespace

std::optional<double> BoxChoice::error() const {
  if (!grid || !sample) return std::nullopt;
  return std::hypot(*grid, *sample);
}

bool BoxChoice::reaches_goal() const {
  return error() && reaches(*error(), goal);
}

bool needs_choice(const Stage& stage) {
  return !(stage.side > 0.0) || stage.cells == 0;
}

std::vector<BoxChoice> choose_boxes(Study& study, const AccuracyGoal& goal) {
  const AccuracyGoal of_stage = {goal.error / std::sqrt(static_cast<double>(longest_chain(study))),
                                 goal.seconds / static_cast<double>(study.stages.size())};
  std::vector<BoxChoice> choices;
  for (auto& stage : study.stages) {
    if (!needs_choice(stage)) continue;
    const auto as_read = stage;
    const bool is_free = as_read.side == 0.0;
    const int few = std::max(stage.dimensions() == 3 ? 24 : 48, is_free ? fewest_particles(as_read) : 0);
    auto choice = Chooser(study, as_read, of_stage, few).choose(stage);
    // A few particles do not show the width of a distribution of sizes: the choice is made again with more of them.
    const int more = std::min(choice.particles, 12 * few);
    if (is_free && more > 2 * few && has_distribution(as_read)) {
      choice = Chooser(study, as_read, of_stage, more).choose(stage);
    }
    choices.push_back(std::move(choice));
  }
  return choices;
}

}  // namespace breccia

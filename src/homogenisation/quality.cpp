#include "homogenisation/quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "homogenisation/box/filler_on_sides.hpp"
#include "homogenisation/largest_errors.hpp"
#include "homogenisation/modulus_errors.hpp"
#include "homogenisation/narrow_gaps.hpp"
#include "homogenisation/plan/grid_error.hpp"
#include "homogenisation/sample_error.hpp"
#include "io/display.hpp"
#include "study/abscissa_words.hpp"
#include "study/coatings.hpp"
#include "study/filler_sizes.hpp"

namespace breccia {
namespace {

/// A relative difference in words with two digits, in per cent or, if it is large, as a factor.
std::string words_of(double relative) {
  constexpr double least = 1e-3, factor = 1.0;
  if (relative < least) return "less than 0.1 %";
  if (relative < factor) return fmt::format("{:.2g} %", 100.0 * relative);
  const double ratio = 1.0 + relative;
  return ratio < 100.0 ? fmt::format("a factor of {:.2g}", ratio) : fmt::format("a factor of {:.0f}", ratio);
}

/// The time at which the modulus under displacement is furthest below that under traction; nothing where it never is.
std::optional<BoundsAtTime> worst_crossing(const LoadQuality& load) {
  std::optional<BoundsAtTime> worst;
  for (const auto& at : load.times) {
    if (at.crossing() && (!worst || *at.crossing() > *worst->crossing())) worst = at;
  }
  return worst;
}

/// The name of both apparent moduli among those of several loads and methods: "bounds", "bounds under shear, dynamic";
/// "displacement and traction" for a box that is no window, whose moduli bound nothing but its own.
std::string name_of_both(const StageQuality& quality, const LoadQuality& shown) {
  const auto& all = quality.loads;
  std::string name = quality.filler_on_sides ? "bounds" : "displacement and traction";
  if (all.size() == 1 || (shown.load.is_isotropic() && all.front().method == all.back().method)) return name;
  const bool is_one_method = std::ranges::all_of(all, [&](const auto& other) { return other.method == shown.method; });
  return fmt::format("{} under {}{}", name, name_of(shown.load),
                     is_one_method ? "" : fmt::format(", {}", name_of(shown.method)));
}

/// The moduli that a summary reports: those of which the upper one is below the lower one by most, or else the first.
const LoadQuality& shown_bounds(std::span<const LoadQuality> loads) {
  return *std::ranges::max_element(loads, {}, [](const LoadQuality& load) {
    const auto crossed = worst_crossing(load);
    return crossed ? *crossed->crossing() : 0.0;
  });
}

/// Distances at the first and the last time: "4 % apart at 1 ms, 11 % at 100 s"; in frequency at the first and the last
/// frequency, which belong to the last and the first time.
std::string words_on_ends(Abscissa abscissa, AnisotropyAtTime first, AnisotropyAtTime last) {
  if (abscissa == Abscissa::frequency) std::swap(first, last);
  const auto distance = words_of(first.distance);
  return fmt::format("{}{} at {}, {} at {}", distance, distance.starts_with('a') ? "" : " apart",
                     display_in(abscissa, first.time), words_of(last.distance), display_in(abscissa, last.time));
}

/// The distance of the moduli under displacement and traction at the first and the last time.
std::string words_on_bounds(const StageQuality& quality) {
  constexpr auto not_tested = "displacement and traction: not tested";
  if (quality.loads.empty()) return not_tested;
  const auto& shown = shown_bounds(quality.loads);
  if (shown.times.empty()) return not_tested;
  const auto both = name_of_both(quality, shown);
  if (const auto crossed = worst_crossing(shown)) {
    return fmt::format("{}: the modulus under displacement is {} below that under traction at {}", both,
                       words_of(*crossed->crossing()), display_in(quality.abscissa, crossed->time));
  }
  const auto& times = shown.times;
  const auto first = times.front().distance(), last = times.back().distance();
  if (quality.has_films_along_walls)
    return "displacement alone: a traction boundary would take no films along the walls";
  if (!first || !last) {
    return fmt::format(R"({}: only {}, distance unknown (tests.boundaries = ["displacement", "traction"]))", both,
                       name_of(times.front().upper ? Boundary::displacement : Boundary::traction));
  }
  return fmt::format(
      "{} {}", both,
      words_on_ends(quality.abscissa, {times.front().time, std::abs(*first)}, {times.back().time, std::abs(*last)}));
}

/// The distance of the shears at the first and the last time: "shears 4 % apart at 1 ms, 11 % at 100 s".
std::string words_on_anisotropy(const Anisotropy& shears, Abscissa abscissa) {
  return fmt::format("shears {}", words_on_ends(abscissa, shears.first, shears.last));
}

/// The boundary whose errors are meant, where it is one of several.
std::string words_on_boundary(const StageQuality& quality) {
  return quality.is_periodic && !quality.loads.empty() ? " under the periodic boundary" : "";
}

/// The error of the grid under the boundaries beside the periodic one.
std::string words_on_other_grid_error(const StageQuality& quality) {
  if (!quality.grid_share_of_others) return {};
  const bool is_known = *quality.grid_share_of_others < 1.0;
  return fmt::format(", {} under the others",
                     is_known ? "up to " + words_of(*quality.grid_share_of_others) : "of any size");
}

/// The error of one grid by a rule, or the reason why no rule gives it.
std::string words_on_expected_error(const StageQuality& quality) {
  if (!quality.one_grid) return "unknown";
  const auto rule = words_on_rule(*quality.one_grid);
  const auto error = quality.one_grid->error();
  if (!error) return fmt::format("unknown, {}", rule);
  const auto words = words_of(*error);
  return fmt::format("{}{} {}", words.starts_with("less") ? "" : "up to about ", words, rule);
}

std::string words_on_second_grid(const StageQuality& quality) {
  const auto grids = grids_that_measure(quality);
  return grids ? fmt::format(" (cells = [{}] measures it)", fmt::join(*grids, ", ")) : "";
}

/// What is known of the error of grains and films.
std::string words_on_films(const StageQuality& quality) {
  if (quality.rules.one_grid) {
    return fmt::format("films: error of the model up to about {} by a rule", words_of(*quality.rules.one_grid));
  }
  if (quality.debonding && !quality.films.layers) {
    return fmt::format("films: error unknown with {}{}",
                       *quality.debonding == Debonding::spring ? "springs" : "debonded ones",
                       quality.debonding == Debonding::open
                           ? " (with 10 and 20 % of open gaps the mean shear modulus was within 3 % of resolved films, "
                             "the bulk modulus up to 8 % below)"
                           : "");
  }
  const auto other = quality.dimensions == 3
                         ? fmt::format("divisions = {}", quality.films.divisions > 1 ? quality.films.divisions - 1 : 2)
                         : fmt::format("face_share = {:.3g}", 0.5 * quality.films.face_share);
  return fmt::format("films: error of the mesh unknown (a run with tests.films.{} shows it by the difference)", other);
}

std::string words_on_grid(const StageQuality& quality) {
  if (quality.grids.empty()) return words_on_films(quality);
  if (quality.grid_share && *quality.grid_share >= 1.0) {
    return "grid: error of any size, since the grids differ too much, or have nearly as many cells";
  }
  if (quality.grid_share) {
    return fmt::format("grid: error up to {}{}{}", words_of(*quality.grid_share), words_on_boundary(quality),
                       words_on_other_grid_error(quality));
  }
  if (quality.grids.size() > 1) return "grid: error unknown until every grid is tested";
  return fmt::format("grid: one grid, error {}{}", words_on_expected_error(quality), words_on_second_grid(quality));
}

/// What two dimensions leave out.
std::string words_on_space(const FactorOfSpace& space, Abscissa abscissa) {
  return fmt::format("two dimensions: spheres would have up to about {:.2g} times this modulus at {}", space.ratio,
                     display_in(abscissa, space.time));
}

/// The whole error, and whether it is what was asked for; empty where it is not known and nothing was asked for.
std::string words_on_whole_error(const StageQuality& quality) {
  const auto& [error, asked] = std::pair(quality.error, quality.error_asked);
  if (!error) return asked ? fmt::format("error unknown ({} asked for)", words_of(*asked)) : "";
  const bool is_missed = asked && !reaches(*error, *asked);
  return fmt::format("error up to {}{}{}", words_of(*error), words_on_boundary(quality),
                     is_missed ? fmt::format(", more than the {} asked for", words_of(*asked)) : "");
}

/// The error of one packing in place of all.
std::string words_on_packing(const StageQuality& quality) {
  if (!quality.sample_error) return "packing: one seed, scatter unknown";
  return fmt::format("packing: one seed, error up to about {} by a rule", words_of(*quality.sample_error));
}

/// The narrowest gap in cells of each grid: "3 cells", "2 and 4 cells".
std::string words_on_gap(const StageQuality& quality) {
  std::vector<std::string> cells;
  for (const int grid : quality.grids) cells.push_back(fmt::format("{:.2g}", quality.gap_cells_on(grid)));
  const auto last = cells.back();
  cells.pop_back();
  const auto before = cells.empty() ? "" : fmt::format("{} and ", fmt::join(cells, ", "));
  return fmt::format("narrowest gap: {}{} {}{}", before, last, before.empty() && last == "1" ? "cell" : "cells",
                     quality.has_flow ? ", the matrix flows through it" : "");
}

}  // namespace

StageQuality quality_of(const Study& study, const Stage& stage, const StageResult& result) {
  const auto& packed = result.microstructure;
  StageQuality quality{.dimensions = stage.dimensions(),
                       .abscissa = study.tests.abscissa(),
                       .matrix_stage = {},
                       .particles = packed.particles(),
                       .fraction = packed.fraction,
                       .fraction_asked = {},
                       .gap_cells = std::min(packed.gap, packed.wall_gap) / stage.cell_size(),
                       .has_flow = mixing_of(study, stage, packed) == Mixing::flow,
                       .grids = stage.grids(),
                       .is_random = false,
                       .has_films_along_walls = false,
                       .is_periodic = false,
                       .grid_share = {},
                       .grid_share_of_others = {},
                       .loads = bounds_of_tests(result)};
  quality.anisotropy = anisotropy_of_tests(stage.dimensions(), result.tests);
  quality.space = factor_of_space(study, stage, result);
  quality.is_periodic =
      std::ranges::any_of(result.tests, [](const TestResult& test) { return test.id.boundary == Boundary::periodic; });
  const auto errors = largest_errors_of(result);
  quality.grid_share = errors.grid;
  quality.grid_share_of_others = errors.grid_of_others;
  quality.rules = error_rules_of(study, stage, packed);
  quality.error_asked = study.tests.accuracy;
  quality.error = errors.whole;
  quality.sample_error = errors.sample;
  quality.matrix_error = errors.matrix;
  if (const auto* earlier = std::get_if<EarlierStage>(&stage.matrix)) quality.matrix_stage = earlier->name;
  quality.fraction_asked = fraction_asked_of(stage);
  quality.is_random = !stage.fillers.empty() && stage.has_seed();
  if (!quality.loads.empty()) quality.filler_on_sides = filler_on_sides(stage, packed);
  quality.has_films_along_walls = stage.has_films_along_walls();
  const bool is_of_films = std::ranges::any_of(result.tests, [](const auto& test) { return test.id.grid.is_films(); });
  if (is_of_films) {
    quality.grids.clear();
    quality.films = study.tests.films;
    if (stage.bonds) quality.debonding = stage.bonds->kind;
    quality.gap_cells = std::numeric_limits<double>::infinity();
  } else if (stage.grids().size() == 1) {
    quality.one_grid = plan_of_grid(study, stage, packed);
  }
  if (const auto thickness = thinnest_coating(stage)) quality.coating_cells = *thickness / stage.cell_size();
  return quality;
}

std::optional<std::array<int, 2>> grids_that_measure(const StageQuality& quality) {
  if (quality.grids.size() != 1 || (quality.has_flow && quality.dimensions == 3)) return {};
  constexpr int few = 16;
  const int cells = quality.grids.back();
  return cells < few ? std::array{cells, 2 * cells} : std::array{(cells + 1) / 2, cells};
}

std::string words_on_rule(const GridPlan& grid) {
  if (!grid.rule) return fmt::format("no rule for {}", grid.without_rule);
  if (!grid.error()) return "too few cells for a rule";
  return grid.caveat.empty() ? "by a rule" : fmt::format("by a rule {}", grid.caveat);
}

std::string summary_of(const StageQuality& quality) {
  if (quality.particles == 0 && !(quality.fraction > 0.0)) return {};
  std::vector<std::string> parts;
  if (const auto whole = words_on_whole_error(quality); !whole.empty()) parts.push_back(whole);
  if (!quality.is_periodic || !quality.loads.empty()) parts.push_back(words_on_bounds(quality));
  if (quality.anisotropy) parts.push_back(words_on_anisotropy(*quality.anisotropy, quality.abscissa));
  parts.push_back(words_on_grid(quality));
  if (std::isfinite(quality.gap_cells)) parts.push_back(words_on_gap(quality));
  if (quality.coating_cells) parts.push_back(fmt::format("thinnest coating: {:.2g} cells", *quality.coating_cells));
  if (!quality.matrix_stage.empty()) {
    const bool is_known = quality.error && quality.matrix_error;
    parts.push_back(is_known ? fmt::format("matrix: error up to {} from stage {}", words_of(*quality.matrix_error),
                                           quality.matrix_stage)
                             : fmt::format("matrix: the errors of stage {} add to these", quality.matrix_stage));
  }
  if (quality.space) parts.push_back(words_on_space(*quality.space, quality.abscissa));
  if (quality.is_random) parts.push_back(words_on_packing(quality));
  return fmt::format("{}", fmt::join(parts, "; "));
}

StageAccuracy accuracy_of(const StageQuality& quality) {
  return {summary_of(quality), quality.grid_share, quality.rules};
}

StageAccuracy accuracy_of_answer(const StageResult& answer, const ErrorRules& rules) {
  const auto errors = largest_errors_of(answer);
  StageAccuracy accuracy{.grid_error = errors.grid, .rules = rules};
  accuracy.summary = "answered from an earlier result; ";
  if (errors.whole) {
    accuracy.summary += fmt::format("error up to {}", words_of(*errors.whole));
  } else if (accuracy.grid_error && *accuracy.grid_error < 1.0) {
    accuracy.summary += fmt::format("grid: error up to {}; the whole error is unknown", words_of(*accuracy.grid_error));
  } else if (rules.one_grid) {
    accuracy.summary +=
        fmt::format("grid: error up to about {} by a rule; the whole error is unknown", words_of(*rules.one_grid));
  } else {
    accuracy.summary += "error of the grid unknown for these materials";
  }
  return accuracy;
}

std::vector<std::string> warnings_on_bounds(const StageQuality& quality) {
  std::vector<std::string> warnings;
  for (const auto& load : quality.loads) {
    const auto crossed = worst_crossing(load);
    if (!crossed) continue;
    std::string gaps = quality.has_flow ? ", or for 12 cells across the smallest particle" : "";
    const bool counts_gaps = std::isfinite(quality.gap_cells) && !quality.has_flow;
    for (const int grid : counts_gaps ? quality.grids : std::vector<int>()) {
      gaps += fmt::format("{}{:.2g} wide with cells = {}", gaps.empty() ? ", in cells " : ", ",
                          quality.gap_cells_on(grid), grid);
    }
    warnings.push_back(fmt::format(
        "{}, {}: the modulus under displacement is {} below that under traction at {}; likely causes: {} too coarse "
        "for the narrowest gap{}{}; or particles that the sides of the box cut",
        name_of(load.load), name_of(load.method), words_of(*crossed->crossing()),
        display_in(quality.abscissa, crossed->time), quality.grids.size() > 1 ? "grids" : "a grid", gaps,
        load.method == Method::dynamic ? "; ringing of a run with too large a mass scaling factor or too short a ramp"
                                       : ""));
  }
  return warnings;
}

std::vector<std::string> warnings_on_packing(const Study& study, const Stage& stage,
                                             const StageMicrostructure& packed) {
  std::vector<std::string> warnings;
  if (stage.fillers.empty()) return warnings;
  constexpr std::size_t enough_particles = 30;
  const auto particles = packed.particles();
  // Where an error is asked for and a rule gives that of the packing, the result has it.
  const ErrorRules rules{.sample = sample_of(study, stage, packed), .effective_particles = packed.effective_particles};
  const auto has_rule = [&](Boundary boundary) {
    constexpr double stiffening = 2.0;  // of no effect on whether there is a rule
    return sample_error(rules, stage.dimensions(), boundary, Load::shear, stiffening).has_value();
  };
  const bool is_judged = study.tests.accuracy && std::ranges::all_of(study.tests.boundaries, has_rule);
  if (stage.has_seed() && particles < enough_particles && !is_judged) {
    warnings.push_back(fmt::format(
        "only {} particle{} in the box; with fewer than {} another packing may change the modulus by 10 % and more "
        "(packings of other seeds show by how much; a larger box holds more)",
        particles, particles == 1 ? "" : "s", enough_particles));
  }
  constexpr double most_deviation = 0.01, most_relative_deviation = 0.05;
  const auto asked = fraction_asked_of(stage);
  if (asked && std::abs(packed.fraction - *asked) > std::min(most_deviation, most_relative_deviation * *asked)) {
    warnings.push_back(
        fmt::format("the particles fill {:.3g} % of the box where {:.3g} % were asked for; a larger box comes closer",
                    100.0 * packed.fraction, 100.0 * *asked));
  }
  return warnings;
}

}  // namespace breccia

#include "homogenisation/stage_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "discretisation/contrast.hpp"
#include "homogenisation/box/filler_on_sides.hpp"
#include "homogenisation/crystal_warnings.hpp"
#include "homogenisation/dynamic_warnings.hpp"
#include "homogenisation/grain_warnings.hpp"
#include "homogenisation/image_warnings.hpp"
#include "homogenisation/material_warnings.hpp"
#include "homogenisation/narrow_gaps.hpp"
#include "homogenisation/plan/grid_error.hpp"
#include "homogenisation/quality.hpp"
#include "homogenisation/run/test_requests.hpp"
#include "homogenisation/separation.hpp"
#include "homogenisation/size_warnings.hpp"
#include "io/display.hpp"
#include "io/units.hpp"
#include "study/abscissa_words.hpp"
#include "study/coatings.hpp"
#include "study/expansion_rules.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

/// Finer grids in the same proportions, in words, where the coarsest one has this many cells per side; empty if these
/// are finer than any practical grid.
std::string words_on_finer_grids(const std::vector<int>& grids, double coarsest) {
  constexpr double affordable = 20000.0;
  std::vector<std::string> cells;
  for (const int grid : grids) {
    const double needed = std::ceil(coarsest * grid / grids.front());
    if (!(needed <= affordable)) return {};
    cells.push_back(fmt::format("{:.0f}", needed));
  }
  const auto list = cells.size() > 1 ? fmt::format("[{}]", fmt::join(cells, ", ")) : cells.front();
  return fmt::format(" (cells = {} would resolve it)", list);
}

/// The effect of the width of a gap, in cells, on the modulus at long times.
struct GapRule {
  double cells;  ///< number of cells with which a gap is resolved
  const char* consequence;
};

constexpr GapRule gap_rule(Mixing mixing) {
  const double cells = cells_in_resolved_gaps(mixing);
  if (mixing == Mixing::points) {
    return {cells, "the modulus at long times comes out several times too high, at 1 cell tens of times"};
  }
  return {cells,
          "a nearly incompressible matrix cannot be squeezed out of the gap, and the modulus at long times comes out "
          "up to several times too high"};
}

/// Thin films between grains carry the load of the whole composite, and so want more cells than a few narrow gaps.
constexpr GapRule film_rule(Mixing mixing) {
  if (mixing == Mixing::flow) {
    return {0.9, "the modulus at long times comes out too low, by some 12 % with 0.6 cells"};
  }
  auto rule = gap_rule(mixing);
  rule.cells = mixing == Mixing::points ? 6.0 : 2.4;
  return rule;
}

/// A gap of a stage that the grid has to resolve.
struct NarrowGap {
  const char* name;
  double width;  ///< [m]
  GapRule rule;
};

NarrowGap film_of(const StageMicrostructure& packed, Mixing mixing) {
  const bool is_at_wall = packed.wall_gap < packed.gap;
  return {is_at_wall ? "the half film along the walls" : "the film between grains",
          std::min(packed.gap, packed.wall_gap), film_rule(mixing)};
}

/// A warning about a stage without flow through its narrow gaps, though the study has flow.
std::optional<std::string> warning_of_missing_flow(const Study& study, const Stage& stage,
                                                   const StageMicrostructure& packed) {
  const bool lacks_flow = study.tests.mixing == Mixing::flow && model_of(study.tests, stage) == Model::cells &&
                          mixing_of(study, stage, packed) != Mixing::flow;
  if (stage.fillers.empty() || !lacks_flow || !has_narrow_gaps(stage, packed) || has_soft_fillers(study, stage)) {
    return std::nullopt;
  }
  if (stage.has_voids()) {
    return "beside voids the matrix does not flow through gaps narrower than a cell: those between stiff particles are "
           "in series, and the modulus at long times comes out too high where they are not resolved";
  }
  return "its cells are in series, without flow through gaps: a filler or a coating is not stiffer in shear than the "
         "matrix at all times; where the filler is the softer one, coarse grids come out some 10 to 30 % too soft";
}

/// A warning about particles, with flow through the gaps between them, of so few cells that no rule gives the error of
/// the grid.
std::optional<std::string> warning_of_small_particles(const Study& study, const Stage& stage,
                                                      const StageMicrostructure& packed) {
  if (mixing_of(study, stage, packed) != Mixing::flow || packed.grains() != nullptr) return std::nullopt;
  const auto plan = plan_of_grid(study, stage, packed);
  if (!plan || !plan->rule || plan->error()) return std::nullopt;
  const double least = plan->rule->least_cells;
  const bool are_discs = packed.content<Microstructure<2>>() != nullptr;
  return fmt::format(
      "the smallest {}, {}, is {:.2g} cells wide; below {:g} cells no rule gives the error of the grid{}",
      are_discs                 ? "disc"
      : stage.dimensions() == 2 ? "particle"
                                : "sphere",
      display(plan->length, "m", 4), plan->cells(), least,
      words_on_finer_grids(stage.grids(), std::ceil(least * stage.side / plan->length)));
}

/// The narrowest gap between particles or to a wall: a visitor of the content of a box. Nothing where no gap has to be
/// resolved.
struct NarrowestGap {
  const StageMicrostructure& packed;
  const Tests& tests;
  Mixing mixing;

  template <int dim>
  std::optional<NarrowGap> operator()(const Grains<dim>&) const {
    return film_of(packed, mixing);
  }
  template <int dim>
  std::optional<NarrowGap> operator()(const Microstructure<dim>&) const {
    return between_particles<dim>();
  }
  std::optional<NarrowGap> operator()(const ParticleBox&) const { return between_particles<2>(); }
  std::optional<NarrowGap> operator()(const EllipsoidBox&) const { return between_particles<3>(); }
  template <int dim>
  std::optional<NarrowGap> operator()(const SharedImage<dim>&) const {
    return std::nullopt;  // pixels do not distinguish particles
  }

 private:
  /// The matrix in a gap between two spheres of mixed cells is squeezed out on all sides, so that it has no rule of its
  /// own (warning_of_gaps_between_spheres). This does not hold for the gap to a wall of prescribed displacement
  /// (theory, section 11).
  template <int dim>
  [[nodiscard]] std::optional<NarrowGap> between_particles() const {
    if (mixing == Mixing::flow) return std::nullopt;
    if (dim == 2 || mixing == Mixing::points) {
      return NarrowGap{"the smallest gap between particles or to a wall", std::min(packed.gap, packed.wall_gap),
                       gap_rule(mixing)};
    }
    if (std::ranges::count(tests.boundaries, Boundary::displacement) == 0) return std::nullopt;
    return NarrowGap{"the smallest gap of a particle to a wall",
                     packed.wall_gap,
                     {1.0,
                      "a nearly incompressible matrix cannot be squeezed out between the wall and the particles, and "
                      "the modulus under displacement at long times comes out too high, with half a cell by a third"}};
  }
};

/// A clause that the difference of several grids shows by how much narrow gaps change the modulus; empty for one grid.
std::string words_on_several_grids(const Stage& stage) {
  return stage.coarser_cells.empty() ? "" : "; the difference of the grids shows by how much";
}

/// Advice on flow through gaps that the cells do not resolve: that the deck may ask for it or, in the plane, where it
/// is for most decks, what it expects; none where a filler or a coating is not stiffer than the matrix (mixing_of).
std::string words_on_flow(const Study& study, const Stage& stage) {
  if (!are_stiffer_than_matrix(materials_of(stage, expected_matrix(study, stage)))) return {};
  const auto obstacles = obstacles_to_flow(study);
  if (stage.dimensions() == 3 && !obstacles.empty()) return {};
  if (obstacles.empty()) return R"(; tests.mixing = "flow" represents it)";
  return fmt::format(R"(; tests.mixing = "flow" represents it ({}))", fmt::join(obstacles, "; "));
}

std::optional<std::string> warning_of_narrow_gaps(const Stage& stage, const StageMicrostructure& packed,
                                                  const Study& study) {
  if (has_mixed_cells(study.tests.mixing) && has_soft_fillers(study, stage)) return std::nullopt;
  const auto narrow = visit_nested(NarrowestGap{packed, study.tests, mixing_of(study, stage, packed)}, packed.box);
  if (!narrow) return std::nullopt;
  const auto& [name, gap, rule] = *narrow;
  const auto [cells_per_gap, consequence] = rule;
  constexpr double rounding = 1e-9;
  // The coarsest grid has a part in the extrapolation or in the error band.
  const auto grids = stage.grids();
  const double cells = gap / stage.side * grids.front();
  if (cells >= cells_per_gap * (1.0 - rounding)) return std::nullopt;
  const auto shown = display_beside(cells, cells_per_gap);
  return fmt::format("{}, {}, is {} {} wide{}; below {:g} {} {}{}{}{}", name, display(gap, "m", 4), shown,
                     shown == "1" ? "cell" : "cells",
                     grids.size() > 1 ? fmt::format(" on the coarsest grid, of {} cells a side", grids.front()) : "",
                     cells_per_gap, cells_per_gap == 1.0 ? "cell" : "cells", consequence, words_on_several_grids(stage),
                     words_on_finer_grids(grids, std::ceil(cells_per_gap * stage.side / gap * (1.0 - rounding))),
                     study.tests.mixing == Mixing::series ? words_on_flow(study, stage) : "");
}

/// Whether a matrix is nearly incompressible after a time [s]: its Poisson's ratio is above 0.45.
bool becomes_nearly_incompressible(const Material& matrix, double time) {
  constexpr double shear_over_bulk = 0.1;
  return matrix.shear.at(time) < shear_over_bulk * matrix.bulk.at(time);
}

/// A warning about spheres that almost touch, in cells that do not represent the flow of the matrix out of their gaps.
std::optional<std::string> warning_of_gaps_between_spheres(const Study& study, const Stage& stage,
                                                           const StageMicrostructure& packed) {
  const auto matrix = expected_matrix(study, stage);
  if (!has_spheres_that_almost_touch(stage, packed) || mixing_of(study, stage, packed) != Mixing::series ||
      !are_stiffer_than_matrix(materials_of(stage, matrix)) ||
      !becomes_nearly_incompressible(matrix, study.tests.last_time)) {
    return std::nullopt;
  }
  return fmt::format(
      "the smallest gap between spheres, {}, is {:.2g} cells wide; cells in series do not represent the flow of a "
      "nearly "
      "incompressible matrix out of such a gap: the modulus at long times may be far too high, or too low where a "
      "plane "
      "of nodes is in the gaps{}",
      display(packed.gap, "m", 4), packed.gap / stage.cell_size(), words_on_flow(study, stage));
}

/// A warning about gaps between particles that are narrower than those with which flow was tested.
std::optional<std::string> warning_of_touching_particles(const Study& study, const Stage& stage,
                                                         const StageMicrostructure& packed) {
  const bool has_flow = mixing_of(study, stage, packed) == Mixing::flow && packed.grains() == nullptr;
  if (!has_flow || !has_particles_that_touch(stage, packed)) return std::nullopt;
  const double least = narrowest_tested_gap(stage.dimensions());
  return fmt::format(
      "the smallest gap between particles is {}; flow was tested with gaps of {:g} % of a diameter and more, here {}, "
      "and the modulus of particles that touch does not converge with finer grids",
      display(packed.gap, "m", 4), 100.0 * least, display(least * packed.mean_diameter(), "m"));
}

/// A warning about spheres of so few cells, or so close to jamming, that no rule gives the error of the grid.
std::optional<std::string> warning_of_small_spheres(const Stage& stage, const StageMicrostructure& packed,
                                                    Mixing mixing) {
  if (packed.content<Microstructure<3>>() == nullptr || mixing != Mixing::series) return std::nullopt;
  const double diameter = packed.mean_diameter();
  const double cells = diameter / stage.side * stage.grids().front();
  const auto rule = error_rule_of_spheres(packed.fraction);
  if (!std::isfinite(cells) || (rule && rule->error_with(cells))) return std::nullopt;
  if (!rule) {
    if (stage.packed_by<LatticePacking>() != nullptr) return std::nullopt;  // all gaps of a lattice are equal
    return fmt::format(
        "spheres that fill {:.3g} % are close to jamming, where the modulus at long times comes out far too low unless "
        "the grid resolves their gaps; the mean sphere, {}, is {:.2g} cells wide: try several grids",
        100.0 * packed.fraction, display(diameter, "m"), cells);
  }
  constexpr double tenth = 0.1;
  return fmt::format("the mean sphere, {}, is {:.2g} cells wide, too few to tell the error of the grid{}",
                     display(diameter, "m"), cells,
                     words_on_finer_grids(stage.grids(), std::ceil(rule->cells_for(tenth) * stage.side / diameter)));
}

/// A warning about coatings that the grid does not resolve.
std::optional<std::string> warning_of_thin_coatings(const Stage& stage, Mixing mixing) {
  const double cells_per_coating = mixing == Mixing::points ? 3.0 : 2.0;
  constexpr double rounding = 1e-9;
  const auto thickness = thinnest_coating(stage);
  if (!thickness) return std::nullopt;
  const auto grids = stage.grids();
  const double cells = *thickness / stage.side * grids.front();
  if (cells >= cells_per_coating * (1.0 - rounding)) return std::nullopt;
  const auto shown = display_beside(cells, cells_per_coating);
  return fmt::format(
      "the thinnest coating, {}, is {} {} wide{}; below {:g} cells the strains in it are not resolved, and a coating "
      "far softer than its particle counts for too much or too little{}",
      display(*thickness, "m", 4), shown, shown == "1" ? "cell" : "cells",
      grids.size() > 1 ? fmt::format(" on the coarsest grid, of {} cells a side", grids.front()) : "",
      cells_per_coating,
      words_on_finer_grids(grids, std::ceil(cells_per_coating * stage.side / *thickness * (1.0 - rounding))));
}

/// A warning about filler that the sides of a window cut, where a test prescribes displacements or tractions on them.
std::optional<std::string> warning_of_cut_filler(const Stage& stage, const std::vector<Boundary>& boundaries,
                                                 const StageMicrostructure& packed) {
  const bool cuts = std::ranges::any_of(boundaries, [](Boundary one) { return one != Boundary::periodic; });
  const double share = cuts ? filler_on_sides(stage, packed).value_or(0.0) : 0.0;
  if (!(share > 0.0)) return std::nullopt;
  return fmt::format(
      "the sides of the box cut filler, over {} % of their {}: a displacement boundary moves it with the sides, "
      "and its modulus is an upper bound, far too high where the filler is far stiffer than the matrix; a traction "
      "boundary leaves it free, a lower bound; both come closer in a larger box{}",
      share < 0.1 ? fmt::format("{:.2g}", 100.0 * share) : fmt::format("{:.0f}", 100.0 * share),
      stage.dimensions() == 3 ? "area" : "length",
      stage.is_periodic()
          ? ", and the boundary \"periodic\" does neither: its modulus comes nearest to that of the material"
          : "");
}

/// A warning about a gap in material points together with several grids: the gap, and so the material, depends on the
/// finest grid.
std::optional<std::string> warning_of_gap_on_grids(const Stage& stage) {
  const auto filler = std::ranges::find(stage.fillers, GapSource::points, &Filler::gap_source);
  if (filler == stage.fillers.end() || stage.coarser_cells.empty()) return std::nullopt;
  const auto gap = readable(filler->gap, Dimension::length);
  return fmt::format(
      "the gap between particles, {}, follows from the finest grid: with other cells it would be another "
      "material; give it as a length, gap = \"{}\"",
      gap, gap);
}

std::vector<std::string> warnings_of_unknown_times(const Stage& stage, const Tests& tests) {
  const auto* matrix = std::get_if<Material>(&stage.matrix);
  if (matrix == nullptr) return {};
  return warnings_of_unknown_times(*matrix, {tests.first_time, tests.last_time}, tests.abscissa());
}

/// A warning on a measurement of which the tests have no time, or not all points; empty if they have all.
std::optional<std::string> warning_of_other_times(const Measurement& measurement, const Tests& tests) {
  const TimeWindow times = {tests.first_time, tests.last_time}, all = {0.0, std::numeric_limits<double>::infinity()};
  const auto known = measurement.known_within(all);
  const auto abscissa = tests.abscissa();
  const auto windows = [&](const TimeWindow& of_measurement) {
    return fmt::format("it is known {}, and tests.{} go {}", window_in(abscissa, of_measurement),
                       tests.by_frequency ? "frequencies" : "times", window_in(abscissa, times));
  };
  if (!measurement.known_within(times)) {
    const auto reason = known ? windows(*known) : "none of its own times is within measurements.times";
    return fmt::format("the measurement \"{}\" is not compared: {}", measurement.label, reason);
  }
  // A relaxation curve has no points in frequency.
  if (tests.by_frequency && measurement.dynamic.empty()) return std::nullopt;
  const auto points = measurement.points_within(all), compared = measurement.points_within(times);
  if (points.size() == compared.size()) return std::nullopt;
  const auto left_out = points.size() - compared.size();
  return fmt::format("{} of the {} points of the measurement \"{}\" {} not compared: {}", left_out, points.size(),
                     measurement.label, left_out == 1 ? "is" : "are",
                     windows({std::ranges::min(points), std::ranges::max(points)}));
}

}  // namespace

std::vector<std::string> warnings_on(const Study& study, const Stage& stage,
                                     const StageMicrostructure& microstructure) {
  std::vector<std::string> of_stage;
  if (auto warning = warning_of_gap_on_grids(stage)) of_stage.push_back(*std::move(warning));
  const auto of_deck = study.provenance.warnings.find(stage.name);
  if (of_deck != study.provenance.warnings.end()) std::ranges::copy(of_deck->second, std::back_inserter(of_stage));
  std::ranges::move(warnings_of_soft_fillers(study, stage), std::back_inserter(of_stage));
  std::ranges::move(warnings_of_crystals(study, stage, microstructure), std::back_inserter(of_stage));
  const auto warning_of_gaps = model_of(study.tests, stage) == Model::films
                                   ? warning_of_films(microstructure, study.tests.films)
                                   : warning_of_narrow_gaps(stage, microstructure, study);
  for (const auto& warning :
       {warning_of_large_particles(stage, microstructure), warning_of_separation(study, stage, microstructure),
        warning_of_thin_coatings(stage, study.tests.mixing), warning_of_missing_flow(study, stage, microstructure),
        warning_of_small_particles(study, stage, microstructure), warning_of_gaps,
        warning_of_gaps_between_spheres(study, stage, microstructure),
        warning_of_touching_particles(study, stage, microstructure),
        warning_of_small_spheres(stage, microstructure, mixing_of(study, stage, microstructure)),
        warning_of_lost_grains(stage, microstructure),
        warning_of_cut_filler(stage, study.tests.boundaries, microstructure)}) {
    if (warning) of_stage.push_back(*warning);
  }
  std::ranges::move(warnings_of_debonding(stage, microstructure, study.tests.films), std::back_inserter(of_stage));
  std::ranges::move(warnings_on_image(study, stage), std::back_inserter(of_stage));
  std::ranges::move(warnings_of_unknown_times(stage, study.tests), std::back_inserter(of_stage));
  // It is of the tests of all stages.
  const bool is_first = study.stages.empty() || study.stages.front().name == stage.name;
  if (auto warning = warning_of_ringing(study.tests); warning && is_first) of_stage.push_back(*std::move(warning));
  if (asks_for_expansion(study)) {
    if (const auto obstacle = obstacle_to_expansion(study, stage)) {
      of_stage.push_back(fmt::format("no thermal expansion: {}", *obstacle));
    } else if (stage.has_image() || stage.is_listed()) {
      of_stage.push_back(fmt::format("its thermal expansion is that of an isotropic composite, which {} may not show",
                                     stage.has_image() ? "an image" : "a list of particles"));
    }
  }
  for (const auto& measurement : study.measurements) {
    if (measurement.stage != stage.name) continue;
    const auto warning = warning_of_other_times(measurement, study.tests);
    if (warning) of_stage.push_back(*warning);
  }
  std::ranges::move(warnings_on_packing(study, stage, microstructure), std::back_inserter(of_stage));
  auto warnings = warnings_on_materials(study, stage);
  for (const auto& warning : of_stage) warnings.push_back(fmt::format("{}: {}", stage.name, warning));
  return warnings;
}

}  // namespace breccia

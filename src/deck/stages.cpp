#include "deck/stages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "deck/amounts.hpp"
#include "deck/filler.hpp"
#include "deck/film_bonds.hpp"
#include "deck/image.hpp"
#include "deck/materials.hpp"
#include "deck/packing.hpp"
#include "io/nearest_name.hpp"
#include "study/filler_sizes.hpp"
#include "study/limits.hpp"
#include "study/side_of_particles.hpp"
#include "study/stage_rules.hpp"

namespace breccia {

namespace {

std::string read_name(const Section& section, const std::vector<Stage>& earlier,
                      const std::vector<ShiftedMaterial>& materials) {
  auto name = section.text("name");
  for (const auto& mistake : mistakes_of_name(name, earlier, materials)) section.report("name", mistake);
  return name;
}

/// Whether one of these stages of a deck has a name.
bool has_name(std::span<const Section> stages, const std::string& name) {
  return std::ranges::any_of(
      stages, [&name](const Section& stage) { return stage.kind("name") == Kind::text && stage.text("name") == name; });
}

/// Reads the name of a material or of an earlier stage; `later` are the stage itself and those after it.
StageMatrix read_matrix(const Section& section, const std::vector<Stage>& earlier, std::span<const Section> later,
                        const std::vector<ShiftedMaterial>& materials) {
  const auto name = section.text("matrix");
  if (name.empty()) return {};
  std::vector<std::string> known;
  for (const auto& one : materials) {
    if (one.material.name == name) {
      if (one.constants) refuse_crystal(section, "matrix", one.material);
      return one.material;
    }
    known.push_back(one.material.name);
  }
  for (const auto& stage : earlier) {
    if (stage.name == name) return EarlierStage{name};
    known.push_back(stage.name);
  }
  if (name == name_of_void) {
    section.report("matrix", "expected a solid: only fillers are voids");
  } else if (section.kind("name") == Kind::text && section.text("name") == name) {
    section.report("matrix", "a stage cannot be its own matrix: expected a material or an earlier stage");
  } else if (has_name(later, name)) {
    section.report("matrix",
                   fmt::format("the stage \"{}\" is no earlier one: stages are computed in the order in which "
                               "they stand; expected it before this one",
                               name));
  } else {
    section.report("matrix", fmt::format("unknown material or earlier stage \"{}\"{}", name, suggestion(name, known)));
  }
  return {};
}

/// Reads the cells per side of several grids, of which the finest gives the result and the others its error.
std::vector<int> read_grids(const Section& section) {
  std::vector<int> grids;
  for (const auto cells : section.integers("cells", allowed::cells)) {
    grids.push_back(static_cast<int>(cells));
  }
  // An empty list has been reported already.
  if (grids.empty()) return {static_cast<int>(allowed::cells.lower)};
  if (!can_be_extrapolated(grids)) {
    section.report("cells",
                   fmt::format("expected an integer, or two or three rising ones, such as [100, 200], of which "
                               "the finest gives the result and the others its error, got [{}]",
                               fmt::join(grids, ", ")));
    return {static_cast<int>(allowed::cells.lower)};
  }
  return grids;
}

/// Cells per side from `cells`, or from `resolution` in material points per length (two a cell).
int read_cells(const Section& section, double side) {
  const auto key = section.exactly_one({"cells", "resolution"});
  if (key == "cells") {
    return static_cast<int>(section.integer(key, allowed::cells));
  }
  if (key.empty()) return 0;
  const double points_per_length = section.quantity(key, Dimension::inverse_length, Range::positive());
  const double cells = std::round(side * points_per_length / 2.0);
  if (std::isnan(cells)) return 0;
  if (!accepts(allowed::cells, cells)) {
    section.report(key, fmt::format("expected a resolution that gives between {} and {} cells per side, got {:.6g}",
                                    allowed::cells.lower, allowed::cells.upper, cells));
    return 0;
  }
  return static_cast<int>(cells);
}

/// Whether a stage is one of grains that are computed with films, which need no cells.
bool needs_no_cells(const Section& section, Model model) {
  if (model != Model::films) return false;
  const auto packing = section.optional_section("packing");
  return packing && has_method(*packing, PackingName::laguerre);
}

/// Cells per side of the labels of grains that are computed with films, in the plane and in space.
constexpr int cells_of_labels = 512, cells_of_labels_in_space = 96;

/// Reads the grids of a stage whose box is known. Leaves 0 cells where they are to be chosen.
void read_grid(const Section& section, Model model, Stage& stage) {
  if (section.kind("cells") == Kind::array) {
    section.refuse({"resolution"}, "the cells are given already");
    stage.coarser_cells = read_grids(section);
    stage.cells = stage.coarser_cells.back();
    stage.coarser_cells.pop_back();
  } else if (names_cells(section)) {
    stage.cells = read_cells(section, stage.side);
  } else if (needs_no_cells(section, model)) {
    stage.cells = stage.dimensions() == 3 ? cells_of_labels_in_space : cells_of_labels;
  } else if (stage.has_image()) {
    stage.cells = cells_of_points(section, stage);
  }
}

/// Whether the particles of a stage are drawn, so that their sizes and their fraction give the box of a number of them.
bool draws_particles(const Stage& stage) {
  const auto is_list = [](const Filler& filler) {
    return filler.sizes && std::holds_alternative<ListedSizes>(*filler.sizes);
  };
  return stage.has_seed() && !stage.fillers.empty() && std::ranges::none_of(stage.fillers, is_list);
}

/// Whether sizes or a fraction are missing or wrong, which has been reported already.
bool has_mistaken_amounts(const Stage& stage) {
  return std::ranges::any_of(stage.fillers, [&](const Filler& filler) {
    const auto range = diameters_of(filler);
    const bool has_sizes = range && range->smallest > 0.0 && range->smallest <= range->largest;
    return !has_sizes || !(stage.has_grains() || filler.fraction.value_or(0.0) > 0.0);
  });
}

/// Reads the number of particles of a stage without a box. Leaves the side 0 where the box is to be chosen, and NaN
/// after a mistake.
double read_side_of_particles(const Section& section, const Stage& stage) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  constexpr std::string_view only_drawn =
      "only particles that a random packing draws from sizes and a fraction have a box that follows from their number";
  const auto particles = section.optional_integer("particles", allowed::particles);
  // A packing that could not be read has no fillers.
  if (section.has("filler") && stage.fillers.empty()) return unknown;
  if (!draws_particles(stage)) {
    if (section.has("particles")) {
      section.report("particles", fmt::format("{}; expected box", only_drawn));
    } else {
      section.report("box", fmt::format("missing, expected the side of the box: {}", only_drawn));
    }
    return unknown;
  }
  if (section.has("particles")) {
    double side = unknown;
    if (!particles || has_mistaken_amounts(stage)) return side;
    section.report_errors_of("particles", [&] {
      side = side_of_particles(stage, static_cast<int>(*particles));
      if (accepts(allowed::side, side)) return;
      throw InputError(fmt::format(
          "expected particles for a box of {} to {}, got one of {}", readable(allowed::side.lower, Dimension::length),
          readable(allowed::side.upper, Dimension::length), readable(side, Dimension::length)));
    });
    return side;
  }
  if (!names_cells(section)) return 0.0;
  section.report("box", "missing, expected box or particles beside these cells; without them, too, both are chosen");
  return unknown;
}

/// Reads a stage whose box follows from its particles: these first.
void read_particles_and_box(const Section& section, const std::vector<ShiftedMaterial>& materials,
                            const StageDefaults& defaults, const FractionsByAmounts& fractions, Stage& stage) {
  stage.side = std::numeric_limits<double>::quiet_NaN();
  read_fillers(section, materials, defaults.walls, fractions, stage);
  stage.side = read_side_of_particles(section, stage);
  read_grid(section, defaults.model, stage);
}

}  // namespace

bool names_cells(const Section& stage) {
  return stage.has("cells") || stage.has("resolution");
}

std::vector<Stage> read_stages(const Section& deck, const std::vector<ShiftedMaterial>& materials,
                               const StageDefaults& defaults) {
  const bool is_of_space = deck.optional_integer("dimensions", allowed::dimensions).value_or(2) == 3;
  std::vector<Stage> stages;
  const auto sections = deck.sections("stages");
  const auto fractions = read_amounts(sections, materials);
  for (const auto& section : sections) {
    const auto& by_amounts = fractions[stages.size()];
    Stage stage;
    if (is_of_space) stage.packing = PackingMethod<3>();
    stage.name = read_name(section, stages, materials);
    stage.matrix = read_matrix(section, stages, std::span(sections).subspan(stages.size()), materials);
    const bool is_image = has_image(section);
    section.refuse({"image"}, image_elsewhere);
    if (is_image) {
      read_image(section, materials, defaults.walls, stage);
      read_grid(section, defaults.model, stage);
    } else if (section.has("box")) {
      section.refuse({"particles"}, "the box is given already");
      stage.side = section.quantity("box", Dimension::length, allowed::side);
      read_grid(section, defaults.model, stage);
      read_fillers(section, materials, defaults.walls, by_amounts, stage);
    } else {
      read_particles_and_box(section, materials, defaults, by_amounts, stage);
    }
    read_bonds(section, stage);
    check_fit(section, stage);
    const bool takes_choice = stage.has_seed() && !stage.fillers.empty();
    if (!takes_choice && !is_image && !names_cells(section) && !needs_no_cells(section, defaults.model)) {
      section.report("cells", "missing, expected cells or resolution: they are chosen for a random packing alone");
    }
    stages.push_back(std::move(stage));
  }
  return stages;
}

}  // namespace breccia

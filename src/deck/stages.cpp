#include "stages.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/io/nearest_name.hpp"
#include "breccia/io/safe_name.hpp"
#include "breccia/study/result_names.hpp"

#include "filler.hpp"
#include "packing.hpp"

namespace breccia {

namespace {

constexpr int fewest_cells = 2;
constexpr int most_cells = 1 << 20;
/// Allowed range of the side of a box [m], wide enough for all composites.
const Range sides = {.lower = 1e-12, .upper = 1e6};

std::string lower_case(std::string text) {
  for (auto& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

std::string read_name(const Section& section, const std::vector<Stage>& earlier,
                      const std::vector<Material>& materials) {
  auto name = section.text("name");
  if (!name.empty() && !is_safe_name(name)) {
    section.report("name",
                   fmt::format(R"(expected letters, digits, "-", "_" and "." (it names a directory), got "{}")", name));
  }
  const auto reserved = reserved_names();
  if (std::ranges::find(reserved, lower_case(name)) != reserved.end()) {
    section.report("name", fmt::format("\"{}\" is the name of a file of results", name));
  }
  if (!name.empty() && std::ranges::find(earlier, name, &Stage::name) != earlier.end()) {
    section.report("name", fmt::format("another stage is called \"{}\"", name));
  }
  if (!name.empty() && std::ranges::find(materials, name, &Material::name) != materials.end()) {
    section.report("name", fmt::format("a material is called \"{}\"", name));
  }
  return name;
}

/// Reads the name of a material or of an earlier stage.
StageMatrix read_matrix(const Section& section, const std::vector<Stage>& earlier,
                        const std::vector<Material>& materials) {
  const auto name = section.text("matrix");
  if (name.empty()) return {};
  std::vector<std::string> known;
  for (const auto& material : materials) {
    if (material.name == name) return material;
    known.push_back(material.name);
  }
  for (const auto& stage : earlier) {
    if (stage.name == name) return EarlierStage{name};
    known.push_back(stage.name);
  }
  section.report("matrix", fmt::format("unknown material or earlier stage \"{}\"{}", name, suggestion(name, known)));
  return {};
}

/// Reads the cells per side of several grids for extrapolation.
std::vector<int> read_grids(const Section& section) {
  std::vector<int> grids;
  for (const auto cells : section.integers("cells", {.lower = fewest_cells, .upper = most_cells})) {
    grids.push_back(static_cast<int>(cells));
  }
  constexpr std::size_t fewest = 2, most = 3;
  if (grids.size() < fewest || grids.size() > most || !std::ranges::is_sorted(grids, std::ranges::less_equal())) {
    section.report("cells", "expected an integer, or two or three rising ones to extrapolate from, such as [100, 200]");
    return {fewest_cells};
  }
  return grids;
}

/// Cells per side from `cells`, or from `resolution` in material points per length (two a cell).
int read_cells(const Section& section, double side) {
  const auto key = section.exactly_one({"cells", "resolution"});
  if (key == "cells") {
    return static_cast<int>(section.integer(key, {.lower = fewest_cells, .upper = most_cells}));
  }
  if (key.empty()) return 0;
  const double points_per_length = section.quantity(key, Dimension::inverse_length, Range::positive());
  const double cells = std::round(side * points_per_length / 2.0);
  if (std::isnan(cells)) return 0;
  if (cells < fewest_cells || cells > most_cells) {
    section.report(key, fmt::format("expected a resolution that gives between {} and {} cells per side, got {:.6g}",
                                    fewest_cells, most_cells, cells));
    return 0;
  }
  return static_cast<int>(cells);
}

/// A warning about a gap in material points together with several grids: the gap, and so the material, depends on the
/// finest grid.
std::optional<std::string> warning_of_gap_on_grids(const Stage& stage) {
  const bool follows = stage.filler && stage.filler->gap_source == GapSource::points && !stage.coarser_cells.empty();
  if (!follows) return std::nullopt;
  const auto gap = readable(stage.filler->gap, Dimension::length);
  return fmt::format(
      "the gap between particles, {}, follows from the finest grid: with other cells it would be another "
      "material; give it as a length, gap = \"{}\"",
      gap, gap);
}

}  // namespace

std::vector<Stage> read_stages(const Section& deck, const std::vector<Material>& materials) {
  std::vector<Stage> stages;
  for (const auto& section : deck.sections("stages")) {
    Stage stage;
    stage.name = read_name(section, stages, materials);
    stage.matrix = read_matrix(section, stages, materials);
    stage.side = section.quantity("box", Dimension::length, sides);
    if (section.kind("cells") == Kind::array) {
      section.refuse({"resolution"}, "the cells are given already");
      stage.coarser_cells = read_grids(section);
      stage.cells = stage.coarser_cells.back();
      stage.coarser_cells.pop_back();
    } else {
      stage.cells = read_cells(section, stage.side);
    }
    section.refuse({"image"}, discs_alone);
    stage.filler = read_filler(section, stage, materials);
    if (auto warning = warning_of_gap_on_grids(stage)) stage.warnings.push_back(*std::move(warning));
    stages.push_back(std::move(stage));
  }
  return stages;
}

}  // namespace breccia
